// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A log folder from the file that a vehicle's own software wrote.

#include "fathom/base/exit_code.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/leaves_its_folder.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/files/temporary.h"
#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/camera/camera_file.h"
#include "fathom/camera/mount_file.h"
#include "fathom/camera/tags_file.h"
#include "fathom/findings/pose_twist_check.h"
#include "fathom/findings/stamp_check.h"
#include "fathom/images/video_reader.h"
#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/recording/contents_json.h"
#include "fathom/import/suggest/suggest_map.h"
#include "fathom/log/read_log.h"
#include "fathom/log/write_log.h"
#include "fathom/open_log/survey.h"
#include "fathom/report/table.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/output_folder.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/wide_flag.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
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
DECLARE_bool(wide);

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

// "dive.BIN: dataflash, 288 kB, 39 channels, 402 fields"
std::string Heading(const std::filesystem::path& file, const Contents& contents) {
  const double kilobytes = static_cast<double>(contents.size_bytes) / 1e3;
  std::size_t num_fields = 0;
  for (const Channel& channel : contents.channels) num_fields += channel.fields.size();
  std::string text = fmt::format("{}: {}, {:.0f} kB, {}, {}",
                                 ShownOnOneLine(file.string()),
                                 contents.format,
                                 kilobytes,
                                 Plural(contents.channels.size(), "channel"),
                                 Plural(num_fields, "field"));
  if (contents.IsComplete()) return text;
  const double share =
      static_cast<double>(contents.read_bytes) / static_cast<double>(contents.size_bytes);
  return text + fmt::format("; incomplete: {} of {} bytes are sound ({:.1f} %)",
                            contents.read_bytes,
                            contents.size_bytes,
                            100.0 * share);
}

// "Roll [deg], Pitch [deg], ..."; with --wide all of them.
std::string FieldsText(const Channel& channel) {
  constexpr std::size_t kMostCharacters = 45;
  std::string text;
  for (const Field& field : channel.fields) {
    const std::string unit = field.unit.empty() ? "" : fmt::format(" [{}]", field.unit);
    const std::string entry = (text.empty() ? "" : ", ") + ShownOnOneLine(field.name + unit);
    if (!FLAGS_wide && text.size() + entry.size() > kMostCharacters) return text + ", ...";
    text += entry;
  }
  return text;
}

void PrintContents(const std::filesystem::path& file, const Contents& contents) {
  fmt::print("{}\n\n", Heading(file, contents));
  Table table;
  table.columns = {{"channel"},
                   {"type", false, 3},
                   {"count", true, 1},
                   {"first [s]", true, 2},
                   {"last [s]", true, 2},
                   {"rate [Hz]", true},
                   {"fields"}};
  for (const Channel& channel : contents.channels) {
    // A rate of two or three messages says nothing.
    const bool has_span = channel.count > 3 && channel.first && *channel.last > *channel.first;
    const double span = has_span ? *channel.last - *channel.first : 0.0;
    table.rows.push_back(
        {{ShownOnOneLine(channel.name),
          ShownOnOneLine(channel.type),
          std::to_string(channel.count),
          channel.first ? fmt::format("{:.3f}", *channel.first) : "-",
          channel.last ? fmt::format("{:.3f}", *channel.last) : "-",
          has_span ? fmt::format("{:.1f}", static_cast<double>(channel.count - 1) / span) : "-",
          FieldsText(channel)}});
  }
  fmt::print("{}", TableForTerminal(table));
  for (const std::string& remark : contents.remarks) PrintText(stdout, "note: " + remark + "\n");
}

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

// On stderr, of a recording that holds none of what a map needs. Its remarks may say why.
void TellNothingRecognised(const std::filesystem::path& file, const Contents& contents) {
  PrintText(stderr,
            fmt::format("fathom_import: {0}: nothing in it was recognised, expected {1}. "
                        "fathom_import --from={0} --list says what it holds; docs/import.md says "
                        "how a map is written by hand.\n",
                        file.string(),
                        WhatIsLookedFor(contents.format)));
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

// The text of the map to go by: that of --map, or one that the format makes sure of.
std::string MapText(const std::filesystem::path& file, const std::optional<Vehicle>& vehicle) {
  if (!FLAGS_map.empty()) return ReadFile(FLAGS_map);
  const SuggestedMap suggested = SuggestMap(*OpenRecording(file), vehicle, OwnMaps());
  if (suggested.is_ready) return suggested.text;
  if (!suggested.unknown.empty()) {
    throw InputError(fmt::format(
        "{0}: {1}. Expected with --map a map that says which output drives which thruster, and "
        "which "
        "way round. This prints one to edit: fathom_import --from={0} --suggest{2} > map.yaml",
        file.string(),
        suggested.unknown,
        FLAGS_vehicle.empty() ? "" : " --vehicle=" + FLAGS_vehicle));
  }
  if (!suggested.why_not_ready.empty()) {
    throw InputError(fmt::format(
        "--vehicle={0}: does not go with {1}: {2}. Expected the vehicle of the log, or with --map "
        "a "
        "map that says which output drives which thruster. This prints one to edit: fathom_import "
        "--from={1} --suggest > map.yaml",
        FLAGS_vehicle,
        file.string(),
        suggested.why_not_ready));
  }
  throw InputError(fmt::format(
      "--map: is missing, expected a map file that says what the channels of {0} are. This prints "
      "one to edit: fathom_import --from={0} --suggest{1} > map.yaml{2}",
      file.string(),
      FLAGS_vehicle.empty() ? "" : " --vehicle=" + FLAGS_vehicle,
      suggested.needs_vehicle ? "\nOr give --vehicle, whose thrusters the outputs drive, as "
                                "data/vehicles/bluerov2_heavy.yaml."
                              : ""));
}

// The last part of a path; that of a folder too, with or without a slash at its end.
std::string NameOf(const std::filesystem::path& path) {
  return std::filesystem::absolute(path / "").parent_path().filename().string();
}

// Reads one of the map's camera files. What is called otherwise than such a file, or is a link out
// of the map's folder, may be anybody's: no line of it stands in a message.
template <typename Read>
void RequireCameraFile(const std::filesystem::path& file,
                       const std::filesystem::path& folder,
                       const char* key,
                       const char* what,
                       const Read& read) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw InputError(
        fmt::format("{}: is not there. The map's camera names it as '{}'.", file.string(), key));
  }
  const auto real = std::filesystem::weakly_canonical(file, error);
  const auto inside = std::filesystem::weakly_canonical(folder / ".", error);
  const bool is_own = real.extension() == ".yaml" || real.extension() == ".yml";
  try {
    read(file);
  } catch (const InputError&) {
    if (is_own && !LeavesItsFolder(real.lexically_relative(inside))) throw;
    throw InputError(fmt::format("{}: is no {}, expected one: the map's camera names it as '{}'.",
                                 file.string(),
                                 what,
                                 key));
  }
}

// Throws InputError for a video that is none, or a calibration, tags or mount that are none: before
// anything of them stands in a log.
void RequireCameraFiles(const CameraMap& camera, const std::filesystem::path& from) {
  using Path = std::filesystem::path;
  RequireCameraFile(from / camera.video, from, "video", "video", [](const Path& file) {
    const VideoReader video(file);
  });
  RequireCameraFile(from / camera.calibration,
                    from,
                    "calibration",
                    "calibration of a camera",
                    [](const Path& file) { ReadCameraFile(file); });
  RequireCameraFile(from / camera.tags, from, "tags", "file of tags", [](const Path& file) {
    ReadTagsFile(file);
  });
  RequireCameraFile(from / camera.mount, from, "mount", "mount of a camera", [](const Path& file) {
    ReadMountFile(file);
  });
}

// Puts the video of the map, its calibration, tags and mount into the log's folder: a second name
// for the video's bytes where the disk allows it, as they may be many.
void TakeCameraFiles(const CameraMap& camera,
                     const std::filesystem::path& from,
                     const std::filesystem::path& to) {
  for (const auto& [in_log, named] : camera.Files()) {
    const std::filesystem::path file = from / named;
    std::error_code error;
    if (in_log == camera.Files().front().first) {
      std::filesystem::create_hard_link(file, to / in_log, error);
      if (!error) continue;
    }
    if (!std::filesystem::copy_file(file, to / in_log, error)) {
      throw InputError(
          fmt::format("{}: cannot be copied into the log: {}. The map's camera names it.",
                      file.string(),
                      error.message()));
    }
  }
}

void PrintStream(const char* file, const std::optional<Stream>& stream) {
  if (!stream) return;
  fmt::print("{:<13}{} rows, t = {:.3f} to {:.3f} s\n",
             file,
             stream->time.size(),
             stream->time.front(),
             stream->time.back());
}

// What the log looks like before any fit: which DOFs it can identify, and what is wrong with it.
void PrintFirstLook(const std::filesystem::path& folder, const Log& log) {
  if ((log.command || log.fins || log.shafts) && !log.velocity && !log.pose && !log.video.empty()) {
    fmt::print(
        "note: the motion is in the video. This tracks it: fathom_track --log={0} "
        "--out={0}_tracked\n",
        folder.string());
    return;
  }
  if (!log.velocity && !log.pose) {
    fmt::print("note: the map names no motion, so that the log identifies nothing.\n");
    return;
  }
  if (!log.command && !log.fins && !log.shafts) {
    fmt::print(
        "note: the map names no command, so that the log is taken for a free decay: it tells "
        "damping by inertia.\nnext: fathom_check --log={}\n",
        folder.string());
    return;
  }
  std::vector<Finding> findings = CheckStamps(log);
  std::ranges::move(CheckPoseAgainstTwist(log), std::back_inserter(findings));
  for (const SurveyedDof& surveyed : SurveyLog(folder, std::nullopt).dofs) {
    fmt::print("{}: {}\n",
               Name(surveyed.dof),
               surveyed.why_not.empty() ? "can be identified" : surveyed.why_not);
  }
  PrintNotes(findings);
  fmt::print("next: fathom_check --log={}\n", folder.string());
  std::fflush(stdout);
  PrintWarnings(findings);
}

// The log that is replaced; an empty one where there is none.
Log LogBefore(const std::filesystem::path& folder) {
  try {
    return ReadLog(folder, {.may_lack_motion = true, .may_lack_command = true});
  } catch (const InputError&) {
    return {};
  }
}

// Throws InputError, naming the log to be, for one that no program would read.
void RequireReadable(const std::filesystem::path& made, const std::filesystem::path& folder) {
  try {
    ReadLog(made, {.may_lack_motion = true, .may_lack_command = true});
  } catch (const InputError& error) {
    std::string why = error.what();
    if (why.starts_with(made.string())) why.replace(0, made.string().size(), folder.string());
    throw InputError(why + " The log was not written: mend the map.");
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
  const std::filesystem::path folder = OutputFolder(
      RequireFlag("out", FLAGS_out, "the folder of the log to write"), FLAGS_overwrite);
  RequireWritableFolder(folder);

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
  RequireReadable(made.path(), folder);
  made.TakePlace();

  fmt::print("{}\n", Heading(file, recording->contents()));
  PrintStream("command.csv", log.command ? log.command : log.fins ? log.fins : log.shafts);
  PrintStream("velocity.csv", log.velocity);
  PrintStream("pose.csv", log.pose);
  for (const std::string& remark : imported.remarks) PrintText(stdout, "note: " + remark + "\n");
  PrintFirstLook(folder, log);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
