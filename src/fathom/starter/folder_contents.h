// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/time_interval.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What a folder holds that may be, or become, a log: names of files in it, sorted.
struct FolderContents {
  std::vector<std::string> streams;      // command.csv, velocity.csv, pose.csv, detections.csv
  std::vector<std::string> single_csvs;  // logs by themselves
  std::vector<std::string> recordings;   // what other programs wrote
  std::vector<std::string> videos;
  bool has_images = false;    // a frames.csv
  bool has_log_yaml = false;  // readable or not

  // The first vehicle file that can be read.
  std::string vehicle_file;
  std::optional<Vehicle> vehicle;

  // Of the streams.
  std::vector<Dof> dofs;             // that are commanded and, with a velocity.csv, measured
  std::size_t num_thrusters = 0;     // that command.csv holds the speeds of
  std::optional<TimeInterval> span;  // of the motion
  std::vector<std::string>
      remarks;  // on files that cannot be read or are left out, a sentence each
};

// A CSV is a recording only where the folder holds no stream of a log, and where it is not what a
// program of Fathom wrote. Throws InputError for a
// folder that cannot be read.
FolderContents LookInto(const std::filesystem::path& folder);

}  // namespace fathom
