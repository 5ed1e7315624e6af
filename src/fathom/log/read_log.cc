// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/read_log.h"

#include "fathom/base/files/exists.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/base/shell_word.h"
#include "fathom/log/correct_velocity.h"
#include "fathom/log/log_streams.h"
#include "fathom/log/log_text.h"
#include "fathom/log/single_csv.h"

#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

LogText::File ReadText(const std::filesystem::path& path) {
  return {.name = path.string(), .text = ReadFile(path)};
}

// `file` as given, or in the log's folder.
std::filesystem::path FindVelocity(const std::filesystem::path& folder,
                                   const std::filesystem::path& file) {
  const std::filesystem::path beside = folder / file;
  if (!Exists(beside)) return file;
  std::error_code error;
  if (Exists(file) && !std::filesystem::equivalent(file, beside, error)) {
    throw InputError(fmt::format(
        "--velocity={}: there is such a file here and in {}, expected one. Give the full path.",
        file.string(),
        folder.string()));
  }
  return beside;
}

// The first log folder right inside this one, by name; empty if there is none.
std::filesystem::path FirstLogIn(const std::filesystem::path& folder) {
  std::filesystem::path first;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (!Exists(entry.path() / "log.yaml")) continue;
    if (first.empty() || entry.path() < first) first = entry.path();
  }
  return first;
}

[[noreturn]] void RefuseFolder(const std::filesystem::path& folder) {
  const std::filesystem::path inside = FirstLogIn(folder);
  if (!inside.empty()) {
    throw InputError(fmt::format(
        "{}: holds logs and is none itself, expected one of them: --log={}. fathom_check "
        "--archive={} checks them all.",
        folder.string(),
        ShellWord(inside.string()),
        ShellWord(folder.string())));
  }
  throw InputError(
      fmt::format("{}: holds no log.yaml (name and dof of the log), expected a log folder. "
                  "fathom init {} writes what it lacks. See docs/file_formats.md.",
                  folder.string(),
                  ShellWord(folder.string())));
}

Log ReadFolder(const std::filesystem::path& folder, const ReadLogOptions& options) {
  if (!Exists(folder / "log.yaml")) RefuseFolder(folder);
  if (!options.may_lack_command && !Exists(folder / "command.csv")) {
    throw InputError(fmt::format(
        "{}: holds no command.csv, expected the commanded forces: only fathom_track, "
        "and fathom_identify, fathom_compare, fathom_diagnose and fathom_check of a free "
        "decay, do without them. See docs/file_formats.md.",
        folder.string()));
  }
  const bool has_own_velocity = Exists(folder / "velocity.csv");
  const bool has_motion = has_own_velocity || !options.velocity.empty() ||
                          Exists(folder / "pose.csv") || Exists(folder / "detections.csv");
  if (!has_motion && !options.may_lack_motion) {
    throw InputError(fmt::format(
        "{}: holds neither velocity.csv nor pose.csv nor detections.csv, expected the vehicle's "
        "motion in one of them. Images become detections and poses by fathom_track.",
        folder.string()));
  }

  LogText text;
  text.path = folder;
  text.held_out = options.held_out;
  text.corrections = options.corrections;
  text.corrections_by = options.corrections_by;
  text.log_yaml = ReadText(folder / "log.yaml");
  if (Exists(folder / "command.csv")) text.command = ReadText(folder / "command.csv");
  if (!options.velocity.empty()) {
    text.velocity = ReadText(FindVelocity(folder, options.velocity));
  } else if (has_own_velocity) {
    text.velocity = ReadText(folder / "velocity.csv");
  }
  if (Exists(folder / "pose.csv")) text.pose = ReadText(folder / "pose.csv");
  if (Exists(folder / "pose.yaml")) text.pose_yaml = ReadText(folder / "pose.yaml");
  if (Exists(folder / "detections.csv")) text.detections = ReadText(folder / "detections.csv");

  std::error_code error;
  text.is_other_velocity =
      !options.velocity.empty() &&
      !std::filesystem::equivalent(text.velocity->name, folder / "velocity.csv", error);
  Log log = ParseLog(text);
  if (has_own_velocity && text.is_other_velocity) {
    log.remarks.push_back(
        {RemarkKind::kGeneral,
         fmt::format("velocity.csv: not read, {} is in its place.", options.velocity.string())});
  }
  return log;
}

// A file that is neither a folder nor a single CSV may be what another program wrote, or a single
// CSV with a mistake in its first line.
[[noreturn]] void RefuseForeignFile(const std::filesystem::path& path, const std::string& text) {
  const std::string import = fmt::format(
      "fathom_import makes a log of what other programs write: fathom_import --from={} --suggest > "
      "map.yaml",
      ShellWord(path.string()));
  if (text.empty() || IsMeantAsSingleCsvLog(text)) {
    try {
      ParseSingleCsv(path.string(), text, Dof::kSurge);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{} {}", error.what(), import));
    }
  }
  throw InputError(
      fmt::format("{}: is no log, expected a log folder or a CSV with columns t, tau, v. {}",
                  path.string(),
                  import));
}

// Those of the one speed of a single CSV, by the column's name in a log folder.
std::vector<Correction> OfSpeed(const ReadLogOptions& options,
                                const std::filesystem::path& path,
                                Dof dof) {
  std::vector<Correction> corrections = options.corrections;
  for (Correction& correction : corrections) {
    if (correction.column != "v") {
      throw InputError(fmt::format("{}: corrects {}, which is no speed of {}, expected v.",
                                   options.corrections_by,
                                   Quoted(correction.column),
                                   path.string()));
    }
    correction.column = VelocityColumn(dof);
  }
  return corrections;
}

}  // namespace

Log ReadLog(const std::filesystem::path& path, const ReadLogOptions& options) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return ReadFolder(path, options);
  if (!Exists(path)) {
    throw InputError(path.string() + ": there is no such log folder or CSV file. Check the path.");
  }
  const std::string text = ReadFile(path);
  const bool is_log = IsSingleCsvLog(text) || (options.may_lack_command && IsSingleCsvDecay(text));
  if (!is_log) RefuseForeignFile(path, text);
  if (!options.dof) {
    throw InputError(
        path.string() +
        ": a single CSV (t,tau,v) does not say whose force and speed it holds, expected "
        "--dof with it: --dof=surge, sway, heave, roll, pitch or yaw.");
  }
  if (!options.velocity.empty()) {
    throw InputError(
        fmt::format("--velocity={}: {} is a single CSV with its own speed, expected a log "
                    "folder. Leave out --velocity.",
                    options.velocity.string(),
                    path.string()));
  }
  Log log = ParseSingleCsv(path.string(), text, *options.dof, options.held_out);
  CorrectVelocity(
      "", path.string(), OfSpeed(options, path, *options.dof), options.corrections_by, &log);
  return log;
}

}  // namespace fathom
