// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mistakes.h"
#include "run_tool.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace fathom {

// A log of one DOF with the poses that belong to it: the vehicle goes straight on along x.
struct Dive {
  LogNumbers numbers;
  bool has_pose = false;
  std::vector<double> x, y, yaw;  // of pose.csv, at numbers.time
};

Dive SoundDive(const std::filesystem::path& scratch, bool is_slow);

std::filesystem::path WriteDive(const Dive& dive, const std::filesystem::path& folder);

// What is done to a dive: stamps of the motion that are later, another pose in each row, and what
// the vehicle does under another command f(t, v), by the model that the sound log comes of.
std::function<void(Dive*)> Later(double seconds);
std::function<void(Dive*)> Pose(const std::function<void(Dive*, std::size_t)>& change);
std::function<void(Dive*)> Driven(const std::function<double(double, double)>& force);

// A force that tells all parameters [N].
double Tones(double t);

// What fathom_check says: {severity, code, sentence} of each finding, and why DOFs are left out.
struct Said {
  int exit_code = -1;
  std::vector<nlohmann::json> findings;
  std::string why_not;
  std::string text;
};

// It writes check.json into `scratch`.
Said Check(const std::filesystem::path& log, const std::filesystem::path& scratch);

class CheckTool : public ::testing::Test {
 protected:
  const std::filesystem::path folder_ = EmptyTestFolder();
  Dive dive_ = SoundDive(folder_, false);
};

}  // namespace fathom
