// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/starter/starter.h"

#include "fathom/base/input_error.h"
#include "fathom/base/shell_word.h"
#include "fathom/base/time_interval.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggest_map.h"
#include "fathom/starter/folder_contents.h"
#include "fathom/starter/starter_texts.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVehicleFile = "vehicle.yaml";

// The last part of its path, also of "." and with a slash at its end.
std::string NameOf(const fs::path& folder) {
  std::error_code error;
  const std::string name = fs::canonical(folder, error).filename().string();
  return name.empty() ? "log" : name;
}

void Add(const fs::path& folder, const std::string& name, std::string text, Starter* starter) {
  std::error_code error;
  if (fs::exists(folder / name, error)) {
    starter->kept.push_back(name);
  } else {
    starter->files.push_back({name, std::move(text)});
  }
}

KnownOfLog KnownFrom(const fs::path& folder, const FolderContents& contents) {
  KnownOfLog known;
  known.name = NameOf(folder);
  known.dofs = contents.dofs.empty() ? std::vector{Dof::kSurge} : contents.dofs;
  known.vehicle =
      contents.vehicle ? contents.vehicle_file : kVehicleFile;  // AddVehicle() writes it
  if (!contents.has_images && !contents.videos.empty()) known.video = contents.videos.front();
  known.span = contents.span;
  return known;
}

void AddVehicle(const fs::path& folder, const FolderContents& contents, Starter* starter) {
  if (contents.vehicle) {
    starter->kept.push_back(contents.vehicle_file);
    return;
  }
  const std::size_t num_thrusters = contents.num_thrusters > 0 ? contents.num_thrusters : 2;
  Add(folder, kVehicleFile, StarterVehicleYaml(NameOf(folder), num_thrusters), starter);
}

// What fathom_track or the fits need and the folder has not.
void RemarkOnMissingStreams(const FolderContents& contents, Starter* starter) {
  const bool has_command = std::ranges::count(contents.streams, "command.csv") > 0;
  const bool has_motion = contents.streams.size() > (has_command ? 1U : 0U);
  if (!has_command) {
    starter->remarks.emplace_back("missing: command.csv, the commanded forces or thruster speeds.");
  }
  if (!has_motion && !contents.has_images && contents.videos.empty()) {
    starter->remarks.emplace_back(
        "missing: velocity.csv or pose.csv, the motion; or a video or frames.csv of markers.");
  }
  if (contents.num_thrusters > 0 && !contents.vehicle) {
    starter->remarks.push_back(fmt::format(
        "command.csv holds the speeds of thrusters: give their places in {}.", kVehicleFile));
  }
}

void AddLog(const fs::path& folder, const FolderContents& contents, Starter* starter) {
  Add(folder, "log.yaml", StarterLogYaml(KnownFrom(folder, contents)), starter);
  AddVehicle(folder, contents, starter);
  RemarkOnMissingStreams(contents, starter);
  const bool has_motion = std::ranges::any_of(
      contents.streams, [](const std::string& name) { return name != "command.csv"; });
  const bool has_film = contents.has_images || !contents.videos.empty();
  starter->commands.push_back(fmt::format("{} --log={}",
                                          !has_motion && has_film ? "fathom_track" : "fathom_check",
                                          ShellWord(folder.string())));
}

// From the first stamp of its channels to the last; nothing without stamps.
std::optional<TimeInterval> SpanOf(const Contents& contents) {
  std::optional<TimeInterval> span;
  for (const Channel& channel : contents.channels) {
    if (!channel.first || !channel.last) continue;
    span = {.from = std::min(span ? span->from : *channel.first, *channel.first),
            .to = std::max(span ? span->to : *channel.last, *channel.last)};
  }
  return span;
}

// Empty where the recording's names do not tell of any stream: a map needs one to be read.
std::string MapOf(const fs::path& recording, const std::optional<Vehicle>& vehicle) {
  const auto opened = OpenRecording(recording);
  const SuggestedMap suggested = SuggestMap(*opened, vehicle);
  const std::string text =
      StarterMapYaml(recording.stem().string(), SpanOf(opened->contents()), suggested.text);
  try {
    ParseImportMap("the suggested map", text);
  } catch (const InputError&) {
    return "";
  }
  return text;
}

void AddRecording(const fs::path& folder,
                  const std::string& name,
                  const FolderContents& contents,
                  Starter* starter) {
  const fs::path file = folder / name;
  const std::string map_file = name + ".map.yaml";
  const bool has_thrusters = contents.vehicle && !contents.vehicle->thrusters.empty();
  std::string map;
  try {
    map = MapOf(file, has_thrusters ? contents.vehicle : std::nullopt);
  } catch (const InputError& error) {
    starter->remarks.emplace_back(error.what());
    return;
  }
  if (map.empty()) {
    starter->remarks.push_back(
        fmt::format("{}: no name of a field tells which stream it is, so that there is no map. "
                    "Write {} by docs/import.md.",
                    file.string(),
                    map_file));
    starter->commands.push_back(
        fmt::format("fathom_import --from={} --list", ShellWord(file.string())));
    return;
  }
  Add(folder, map_file, map, starter);
  const fs::path log = folder / fs::path(name).stem();
  std::error_code error;
  if (fs::exists(log / "log.yaml", error)) {
    starter->commands.push_back(fmt::format("fathom_check --log={}", ShellWord(log.string())));
    return;
  }
  const std::string vehicle_file = contents.vehicle ? contents.vehicle_file : kVehicleFile;
  starter->commands.push_back(fmt::format("fathom_import --from={} --map={} --vehicle={} --out={}",
                                          ShellWord(file.string()),
                                          ShellWord((folder / map_file).string()),
                                          ShellWord((folder / vehicle_file).string()),
                                          ShellWord(log.string())));
}

}  // namespace

Starter StarterOf(const fs::path& folder) {
  const FolderContents contents = LookInto(folder);
  Starter starter;
  starter.remarks = contents.remarks;
  const bool is_log = contents.has_log_yaml || !contents.streams.empty();
  if (is_log || (contents.recordings.empty() && contents.single_csvs.empty())) {
    AddLog(folder, contents, &starter);
  } else if (!contents.recordings.empty()) {
    AddVehicle(folder, contents, &starter);
  }
  for (const std::string& name : contents.recordings) {
    AddRecording(folder, name, contents, &starter);
  }
  for (const std::string& name : contents.single_csvs) {
    starter.commands.push_back(
        fmt::format("fathom_check --log={} --dof=surge", ShellWord((folder / name).string())));
  }
  return starter;
}

}  // namespace fathom
