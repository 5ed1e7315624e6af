// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_files.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"
#include "fathom/log/log_yaml.h"

#include <algorithm>
#include <system_error>

namespace fathom {
namespace {

namespace fs = std::filesystem;

// What log.yaml says. Without one that can be read, nothing.
Log LogYamlOf(const fs::path& folder) {
  const fs::path file = folder / "log.yaml";
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  try {
    return ParseLogYaml(file.string(), ReadFile(file));
  } catch (const InputError&) {
    return {};
  }
}

std::set<std::string> NamesOf(const Log& log) {
  std::set<std::string> names = {"camera.yaml",
                                 "command.csv",
                                 "detections.csv",
                                 "frame_times.csv",
                                 "frames.csv",
                                 "log.yaml",
                                 "mount.yaml",
                                 "pose.csv",
                                 "pose.yaml",
                                 "tags.yaml",
                                 "tags_estimated.yaml",
                                 "velocity.csv"};
  if (!log.vehicle.empty()) names.insert(log.vehicle);
  return names;
}

}  // namespace

std::set<std::string> FilesOfLog(const fs::path& folder) {
  std::set<std::string> names = NamesOf(LogYamlOf(folder));
  names.erase("frame_times.csv");  // a recording's, as the video
  if (const Log log = LogYamlOf(folder); log.origin && !log.origin->map.empty()) {
    names.insert(log.origin->map);
  }
  return names;
}

std::vector<fs::path> InputFilesOf(const fs::path& log) {
  std::error_code error;
  if (!fs::is_directory(log, error)) return {log};
  const Log yaml = LogYamlOf(log);
  std::set<std::string> names = NamesOf(yaml);
  if (!yaml.video.empty()) names.insert(yaml.video);
  std::set<fs::path> files;
  for (const std::string& name : names) {
    const fs::path file = log / name;
    if (fs::exists(file, error) && !fs::is_directory(file, error)) files.insert(file);
  }
  if (fs::exists(log / "frames.csv", error)) {
    for (fs::recursive_directory_iterator it(log, error), end; !error && it != end;
         it.increment(error)) {
      std::error_code no_folder;
      if (!it->is_directory(no_folder)) files.insert(it->path());
    }
  }
  return {files.begin(), files.end()};
}

}  // namespace fathom
