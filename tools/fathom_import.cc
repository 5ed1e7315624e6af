// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A log folder from the file that a vehicle's own software wrote.

#include "fathom/base/exit_code.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/files/temporary.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/base/shell_word.h"
#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/recording/contents_json.h"
#include "fathom/import/suggest/suggest_map.h"
#include "fathom/log/read_log.h"
#include "fathom/log/write_log.h"
#include "fathom/tool/camera_files.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/output_folder.h"
#include "fathom/tool/print_contents.h"
#include "fathom/tool/print_imported.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(
    from,
    "",
    "The recording: a CSV of any shape, a .BIN of ArduPilot, a .ulg of PX4, a .tlog, a bag "
    "of ROS, a .mat of MATLAB, a .npy or .npz of numpy, a log of Rock, an .alog of MOOS, or a "
    "folder of such files.");
DEFINE_string(map, "", "Map file (YAML) that says which channel is which stream.");
DEFINE_string(vehicle, "", "Vehicle file (YAML), instead of the one that the map names.");
DEFINE_string(out, "", "Write the log into this folder.");
DEFINE_bool(overwrite, false, "Replace the log in --out.");
DEFINE_bool(list, false, "Only say what the recording holds.");
DEFINE_string(maps,
              "",
              "A folder of map files, each with `when:`. The first that fits the recording goes "
              "before what the format suggests.");
DEFINE_bool(suggest, false, "Only print a map for the recording, to be edited.");
DEFINE_string(json, "", "With --list or --suggest, write that to this JSON file too.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_import",
    "Makes a log folder from the file that a vehicle's own software wrote.",
    "--from=FILE --out=LOG [--map=MAP.yaml --maps=FOLDER --vehicle=VEHICLE.yaml --overwrite] | "
    "--from=FILE "
    "--list | --suggest [--json=FILE]",
    "fathom_import --from=data/recordings/pool.csv --list\n"
    "  fathom_import --from=data/recordings/pool.csv --suggest > map.yaml\n"
    "  fathom_import --from=data/recordings/pool.csv --map=data/recordings/pool_map.yaml "
    "--out=pool",
    "The map says which channel is which stream, in which units and axes: docs/import.md. A log of "
    "ArduSub or PX4 needs none, only --vehicle. Map and vehicle file are copied into the log. What "
    "is left out or assumed is told, a line each. A file that is cut or damaged is read as far as "
    "it is sound."};

// How --map says a table is to be read.
TableOptions TableOptionsFromFlags() {
  return FLAGS_map.empty() ? TableOptions() : ReadImportMap(FLAGS_map).table;
}

// Throws InputError for a recording that is damaged before its first sample.
void RequireSamples(const std::filesystem::path& file, const Contents& contents) {
  const bool has_one = std::any_of(contents.channels.begin(),
                                   contents.channels.end(),
                                   [](const Channel& channel) { return channel.count > 0; });
  if (has_one || contents.IsComplete()) return;
  throw InputError(
      fmt::format("{}: is damaged and holds no sound message, expected one at least.{}{} {} of {} "
                  "bytes are sound.",
                  file.string(),
                  contents.remarks.empty() ? "" : " In it, ",
                  contents.remarks.empty() ? "" : contents.remarks.front(),
                  contents.read_bytes,
                  contents.size_bytes));
}

int List(const std::filesystem::path& file) {
  RequireOutputs({{"json", FLAGS_json}}, {FLAGS_from});
  const auto recording = OpenRecording(file, TableOptionsFromFlags());
  RequireSamples(file, recording->contents());
  PrintContents(file, recording->contents());
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatContents(recording->contents()));
  return 0;
}

// On stderr: stdout is the map.
void TellDamage(const std::filesystem::path& file, const Contents& contents) {
  if (contents.IsComplete()) return;
  PrintText(stderr, Heading(file, contents) + "\n");
  for (const std::string& remark : contents.remarks) PrintText(stderr, "note: " + remark + "\n");
}

// "/imu (sensor_msgs/Imu), /tf (tf2_msgs/TFMessage)", or of a single channel its fields.
std::string WhatItHolds(const Contents& contents) {
  constexpr std::size_t kMost = 10;
  std::vector<std::string> names;
  if (contents.channels.size() == 1) {
    for (const Field& field : contents.channels.front().fields) names.push_back(field.name);
  } else {
    for (const Channel& channel : contents.channels) {
      names.push_back(channel.type.empty() ? channel.name
                                           : fmt::format("{} ({})", channel.name, channel.type));
    }
  }
  const std::size_t num_more = names.size() - std::min(names.size(), kMost);
  names.resize(names.size() - num_more);
  return ShownOnOneLine(fmt::format("{}", fmt::join(names, ", "))) +
         (num_more == 0 ? "" : fmt::format(" and {} more", num_more));
}

// Of a recording that holds none of what a map needs.
std::string NothingRecognised(const std::filesystem::path& file, const Contents& contents) {
  return fmt::format(
      "{0}: nothing in it was recognised, expected {1}. It holds {2}. fathom_import --from={3} "
      "--list tells more. Write into a map which of it is the command and the motion, as "
      "docs/import.md shows.",
      file.string(),
      WhatIsLookedFor(contents.format),
      WhatItHolds(contents),
      ShellWord(file.string()));
}

// On stderr. Its remarks may say why.
void TellNothingRecognised(const std::filesystem::path& file, const Contents& contents) {
  PrintText(stderr, fmt::format("fathom_import: {}\n", NothingRecognised(file, contents)));
  if (!contents.IsComplete()) return;  // TellDamage() told them
  for (const std::string& remark : contents.remarks) PrintText(stderr, "note: " + remark + "\n");
}

// Those of --maps.
std::vector<MapWithWhen> OwnMaps() {
  return FLAGS_maps.empty() ? std::vector<MapWithWhen>() : ReadMapsWithWhen(FLAGS_maps);
}

int Suggest(const std::filesystem::path& file) {
  RequireOutputs({{"json", FLAGS_json}}, {FLAGS_from});
  std::optional<Vehicle> vehicle;
  if (!FLAGS_vehicle.empty()) vehicle = ReadVehicleFile(FLAGS_vehicle);
  const auto recording = OpenRecording(file, TableOptionsFromFlags());
  RequireSamples(file, recording->contents());
  const SuggestedMap map = SuggestMap(*recording, vehicle, OwnMaps());
  TellDamage(file, recording->contents());
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatSuggestion(map));
  if (!map.NamesAStream()) {
    TellNothingRecognised(file, recording->contents());
    return kExitNoFit;
  }
  fmt::print("{}", ShownOnLines(map.text));
  return kExitUsable;
}

// For a command that is proposed.
std::string VehicleForShell() {
  return FLAGS_vehicle.empty() ? "" : " --vehicle=" + ShellWord(FLAGS_vehicle);
}

// The text of the map to go by: that of --map, or one that the format makes sure of.
std::string MapText(const std::filesystem::path& file, const std::optional<Vehicle>& vehicle) {
  if (!FLAGS_map.empty()) return ReadFile(FLAGS_map);
  const auto recording = OpenRecording(file);
  const SuggestedMap suggested = SuggestMap(*recording, vehicle, OwnMaps());
  if (suggested.is_ready) return suggested.text;
  if (!suggested.unknown.empty()) {
    throw InputError(fmt::format(
        "{0}: {1}. Expected with --map a map that says which output drives which thruster, and "
        "which "
        "way round. This prints one to edit: fathom_import --from={2} --suggest{3} > map.yaml",
        file.string(),
        suggested.unknown,
        ShellWord(file.string()),
        VehicleForShell()));
  }
  if (!suggested.why_not_ready.empty()) {
    throw InputError(fmt::format(
        "--vehicle={0}: does not go with {1}: {2}. Expected the vehicle of the log, or with --map "
        "a "
        "map that says which output drives which thruster. This prints one to edit: fathom_import "
        "--from={3} --suggest > map.yaml",
        FLAGS_vehicle,
        file.string(),
        suggested.why_not_ready,
        ShellWord(file.string())));
  }
  if (!suggested.NamesAStream() && !suggested.needs_vehicle) {
    throw InputError("--map: is missing. " + NothingRecognised(file, recording->contents()));
  }
  throw InputError(fmt::format(
      "--map: is missing, expected a map file that says what the channels of {0} are. This prints "
      "one to edit: fathom_import --from={1} --suggest{2} > map.yaml{3}",
      file.string(),
      ShellWord(file.string()),
      VehicleForShell(),
      suggested.needs_vehicle ? "\nOr give --vehicle, whose thrusters the outputs drive, as "
                                "data/vehicles/bluerov2_heavy.yaml."
                              : ""));
}

// The last part of a path; that of a folder too, with or without a slash at its end.
std::string NameOf(const std::filesystem::path& path) {
  return std::filesystem::absolute(path / "").parent_path().filename().string();
}

// The log that is replaced; an empty one where there is none.
Log LogBefore(const std::filesystem::path& folder) {
  try {
    return ReadLog(folder, {.may_lack_motion = true, .may_lack_command = true});
  } catch (const InputError&) {
    return {};
  }
}

// Throws InputError, naming the recording and the log to be, for one that no program would read.
// The remarks may say why: a unit that was taken for another, say.
void RequireReadable(const std::filesystem::path& made,
                     const std::filesystem::path& folder,
                     const std::filesystem::path& file,
                     const std::vector<std::string>& remarks) {
  try {
    ReadLog(made, {.may_lack_motion = true, .may_lack_command = true});
  } catch (const InputError& error) {
    std::string why = error.what();
    if (why.starts_with(made.string())) why.replace(0, made.string().size(), folder.string());
    std::string problem = fmt::format(
        "{}: makes a log that cannot be read: {} The log was not "
        "written: mend {}.",
        file.string(),
        why,
        FLAGS_map.empty() ? "the map" : FLAGS_map);
    for (const std::string& remark : remarks) problem += "\nnote: " + remark;
    throw InputError(problem);
  }
}

int Run() {
  const std::filesystem::path file = RequireFlag("from", FLAGS_from, "the recording to read");
  if (FLAGS_list) return List(file);
  if (FLAGS_suggest) return Suggest(file);
  if (!FLAGS_json.empty())
    throw InputError("--json: goes with --list or --suggest, expected one of them.");
  if (!FLAGS_map.empty() && !FLAGS_maps.empty()) {
    throw InputError("--maps: chooses a map, expected it without --map.");
  }
  RequireFlag("out", FLAGS_out, "the folder of the log to write");

  std::filesystem::path vehicle_file = FLAGS_vehicle;
  std::optional<Vehicle> vehicle;
  if (!FLAGS_vehicle.empty()) vehicle = ReadVehicleFile(vehicle_file);
  const std::string map_text = MapText(file, vehicle);
  const ImportMap map =
      ParseImportMap(FLAGS_map.empty() ? "the suggested map" : FLAGS_map, map_text);
  if (!vehicle && !map.vehicle.empty()) {
    vehicle_file = std::filesystem::path(FLAGS_map).parent_path() / map.vehicle;
    vehicle = ReadVehicleFile(vehicle_file);
  }
  if (map.camera) {
    RequireCameraFiles(*map.camera, std::filesystem::path(FLAGS_map).parent_path());
  }
  const std::filesystem::path folder =
      OutputFolder(FLAGS_out, FLAGS_overwrite, map.camera ? map.camera->Files().front().first : "");
  RequireWritableFolder(folder);
  const auto recording = OpenRecording(file, map.table);
  RequireSamples(file, recording->contents());
  ImportedLog imported = ImportLog(file, *recording, map, vehicle);
  Log& log = imported.log;
  log.origin->file = NameOf(file);
  log.origin->content = ContentOfRecording(file);
  log.origin->map = "map.yaml";
  if (vehicle) log.vehicle = vehicle_file.filename().string();

  const Log before = LogBefore(folder);
  if (!before.corrections.empty()) {
    imported.remarks.emplace_back(
        "correct and late of the log.yaml before are not kept: `scale` and `delay` in the map do "
        "the "
        "same.");
  }
  if (log.held_out.empty()) {
    log.held_out = before.held_out;
    if (!log.held_out.empty()) {
      imported.remarks.emplace_back("held_out is kept from the log.yaml before; the map has none.");
    }
  }

  const Temporary made(folder);
  WriteLog(made.path(), log);
  WriteFile(made.path() / "map.yaml", map_text);
  if (vehicle) WriteFile(made.path() / log.vehicle, ReadFile(vehicle_file));
  if (map.camera) {
    TakeCameraFiles(*map.camera, std::filesystem::path(FLAGS_map).parent_path(), made.path());
  }
  RequireReadable(made.path(), folder, file, imported.remarks);
  made.TakePlace();

  fmt::print("{}\n", Heading(file, recording->contents()));
  PrintStreams(log);
  for (const std::string& remark : imported.remarks) PrintText(stdout, "note: " + remark + "\n");
  PrintFirstLook(folder, log);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
