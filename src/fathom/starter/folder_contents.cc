// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/starter/folder_contents.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"
#include "fathom/import/open_recording.h"
#include "fathom/log/log_streams.h"
#include "fathom/log/single_csv.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> FilesIn(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(fmt::format("{}: there is no such folder. Check the path.", folder.string()));
  }
  std::vector<std::string> names;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored)) names.push_back(at->path().filename().string());
  }
  if (error) {
    throw InputError(fmt::format("{}: cannot be read: {}.", folder.string(), error.message()));
  }
  std::ranges::sort(names);
  return names;
}

// In lower case, with its point.
std::string EndingOf(const std::string& name) {
  std::string ending = fs::path(name).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

bool EndsAs(const std::string& name, const std::vector<std::string>& endings) {
  return std::ranges::count(endings, EndingOf(name)) > 0;
}

bool IsStream(const std::string& name) {
  return name == "command.csv" || name == "velocity.csv" || name == "pose.csv" ||
         name == "detections.csv";
}

// Empty where there is none.
std::string FirstLineOf(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

// The header of what fathom_simulate (t,u) or fathom_refine (a trajectory with its standard
// deviations) writes. Neither holds a command, so that no log can come of it.
bool IsOwnOutput(const std::string& header) {
  return header == "t,x,y,z,qx,qy,qz,qw,sx,sy,sz,sroll,spitch,syaw" ||
         std::ranges::any_of(kAllDofs, [&](const Dof dof) {
           return header == fmt::format("t,{}", VelocityColumn(dof));
         });
}

CsvTable ParseStream(const std::string& name, const std::string& text) {
  if (name == "command.csv") return ParseCommand(name, text);
  if (name == "velocity.csv") return ParseVelocity(name, text);
  if (name == "pose.csv") return ParsePose(name, text);
  return ParseDetections(name, text);
}

bool HasColumn(const Stream& stream, std::string_view name) { return stream.Find(name) != nullptr; }

void TakeCommand(const Stream& command, FolderContents* contents) {
  for (const Dof dof : kAllDofs) {
    if (HasColumn(command, ForceColumn(dof))) contents->dofs.push_back(dof);
  }
  if (!contents->dofs.empty()) return;
  contents->num_thrusters = static_cast<std::size_t>(std::ranges::count_if(
      command.columns, [](const std::string& column) { return column.starts_with("thruster_"); }));
}

void TakeMotion(const std::string& name, const Stream& motion, FolderContents* contents) {
  if (!contents->span) contents->span = {motion.time.front(), motion.time.back()};
  if (name != "velocity.csv") return;
  std::erase_if(contents->dofs,
                [&](const Dof dof) { return !HasColumn(motion, VelocityColumn(dof)); });
}

// command.csv is the first of them.
void TakeStreams(const fs::path& folder, FolderContents* contents) {
  for (const std::string& name : contents->streams) {
    try {
      const Stream stream = ParseStream(name, ReadFile(folder / name)).stream;
      if (name == "command.csv") {
        TakeCommand(stream, contents);
      } else {
        TakeMotion(name, stream, contents);
      }
    } catch (const InputError& error) {
      contents->remarks.emplace_back(error.what());
    }
  }
}

void TakeVehicle(const fs::path& folder, const std::string& name, FolderContents* contents) {
  if (contents->vehicle) return;
  try {
    contents->vehicle = ReadVehicleFile(folder / name);
    contents->vehicle_file = name;
  } catch (const InputError&) {
    // Of the many YAML files that there are, another one.
  }
}

}  // namespace

FolderContents LookInto(const fs::path& folder) {
  const std::vector<std::string> names = FilesIn(folder);
  FolderContents contents;
  std::ranges::copy_if(names, std::back_inserter(contents.streams), IsStream);
  for (const std::string& name : names) {
    const fs::path file = folder / name;
    if (name == "log.yaml") {
      contents.has_log_yaml = true;
    } else if (name == "frames.csv") {
      contents.has_images = true;
    } else if (IsStream(name) || name == "frame_times.csv") {
      continue;
    } else if (EndsAs(name, {".yaml", ".yml"})) {
      TakeVehicle(folder, name, &contents);
    } else if (EndsAs(name, {".mp4", ".avi", ".mkv", ".mov", ".m4v", ".webm"})) {
      contents.videos.push_back(name);
    } else if (EndsAs(name, {".csv", ".tsv"})) {
      const std::string header = FirstLineOf(file);
      if (IsSingleCsvLog(header)) {
        contents.single_csvs.push_back(name);
      } else if (IsOwnOutput(header)) {
        contents.remarks.push_back(fmt::format(
            "{}: left out: a program of Fathom writes such columns, {}.", name, header));
      } else if (contents.streams.empty()) {
        contents.recordings.push_back(name);
      }
    } else if (IsRecording(file)) {
      contents.recordings.push_back(name);
    }
  }
  TakeStreams(folder, &contents);
  return contents;
}

}  // namespace fathom
