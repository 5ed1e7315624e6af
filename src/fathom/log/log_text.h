// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"
#include "fathom/log/log.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// A log in memory, before it is read: the name of each file, as in messages, and its content.
struct LogText {
  struct File {
    std::string name;
    std::string text;
  };
  std::filesystem::path path;
  File log_yaml;
  std::optional<File> command;   // needed but for where only the motion is asked for
  std::optional<File> velocity;  // one of these three at least
  std::optional<File> pose;
  std::optional<File> detections;
  std::optional<File> pose_yaml;        // what is to be said of `pose`
  std::vector<TimeInterval> held_out;   // for HoldOut()
  std::vector<Correction> corrections;  // for CorrectVelocity()
  std::string corrections_by = "--correct";
  bool is_other_velocity = false;  // `velocity` is not the log's own, which log.yaml corrects
};

// ReadLog for files that are in memory already. They throw InputError, naming file, line and
// column.
Log ParseLog(const LogText& text);

// A single CSV `t,tau,v` of one DOF. `held_out`: for HoldOut().
Log ParseSingleCsv(const std::string& name,
                   const std::string& text,
                   Dof dof,
                   const std::vector<TimeInterval>& held_out = {});

}  // namespace fathom
