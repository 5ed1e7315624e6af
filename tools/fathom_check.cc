// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What is wrong with a log, before any fit.

#include "fathom/archive/dives/archive_settings.h"
#include "fathom/archive/dives/walk_archive.h"
#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/check/checked_logs.h"
#include "fathom/check/checkup_json.h"
#include "fathom/check/checkup_page.h"
#include "fathom/check/checkup_text.h"
#include "fathom/check/log_checkup.h"
#include "fathom/check/logs_checkup.h"
#include "fathom/check/logs_text.h"
#include "fathom/log/hold_out.h"
#include "fathom/open_log/open_log.h"
#include "fathom/tool/correct_flag.h"
#include "fathom/tool/default_vehicle_flag.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/held_out_flag.h"
#include "fathom/tool/log_flags.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/progress.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/wide_flag.h"

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(archive, "", "A folder of logs instead of --log: a table of them.");
DEFINE_string(report, "", "Write a page to this HTML file.");
DEFINE_string(json, "", "Write what was found to this JSON file.");
DECLARE_string(log);
DECLARE_string(velocity);

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_check",
    "Says what is wrong with a log, and what it can determine, before any fit.",
    "--log=LOG [--log=LOG ...] [--dof=DOF] [--report=FILE] [--json=FILE] | --archive=DIR",
    "fathom_check --log=data/flatfish --report=check.html",
    "Streams, rates and gaps; broken sensors, wrong signs, units, clocks and axes; how well each "
    "parameter would be known; where a long dive is excited, and what to hold out; of several "
    "logs, "
    "which carry the information. Each finding says what it does to a model and what to do: "
    "docs/check.md.",
    {"log"},
    {},
    "0: no finding is red; 1: a log or a flag cannot be used; 2: a finding is red. A log of "
    "--archive that cannot be used stands in its table and changes no exit code"};

LogCheckup CheckUpByFlags(const std::filesystem::path& path) {
  Log log = OpenLog(path,
                    {.dof = DofFromFlag(),
                     .held_out = HeldOutFromFlag(),
                     .corrections = CorrectionsFromFlag(),
                     .may_lack_motion = true,
                     .may_lack_command = true},
                    DefaultVehicleFromFlag());
  return CheckUp(
      std::move(log),
      {.dof = DofFromFlag(), .data_flags = GivenFlags({"held_out", "correct", "default_vehicle"})});
}

// Several logs: which of them carry the information.
int CheckLogs(const std::vector<std::string>& paths) {
  std::vector<CheckedLog> checked;
  std::vector<Log> logs;
  Progress progress("log");
  bool has_red = false;
  for (const std::string& path : paths) {
    progress.Show(static_cast<int>(checked.size()), static_cast<int>(paths.size()), "");
    checked.push_back({path, "", CheckUpByFlags(path)});
    has_red |= HasRed(checked.back().checkup);
    logs.push_back(checked.back().checkup.log);
  }
  RequireDifferentData(logs);
  RequireHeldOutInside(HeldOutFromFlag(), logs);
  const std::vector<DofOfLogs> dofs = CompareLogs(checked);
  PrintText(stdout, FormatLogs(checked, dofs, TableForTerminal));
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatLogsJson(checked, dofs));
  if (!FLAGS_report.empty()) {
    WriteFile(FLAGS_report, RenderLogsPage(checked, dofs, OriginOfPage(logs)));
  }
  return has_red ? kExitNoFit : kExitUsable;
}

int CheckLog() {
  const std::vector<std::string> paths = LogPathsFromFlags();
  RequireOutputs({{"report", FLAGS_report}, {"json", FLAGS_json}}, paths);
  if (paths.size() > 1) return CheckLogs(paths);
  const LogCheckup checkup = CheckUpByFlags(paths.front());
  RequireHeldOutInside(HeldOutFromFlag(), {&checkup.log, 1});
  PrintText(stdout, FormatCheckup(checkup));
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatCheckupJson(checkup));
  if (!FLAGS_report.empty()) {
    WriteFile(FLAGS_report, RenderCheckupPage(checkup, OriginOfPage({checkup.log})));
  }
  return HasRed(checkup) ? kExitNoFit : kExitUsable;
}

int CheckArchive() {
  for (const auto& [flag, file] : {std::pair{"report", FLAGS_report}, {"json", FLAGS_json}}) {
    if (!file.empty()) {
      throw InputError(fmt::format("--{}: goes with --log, expected none with --archive.", flag));
    }
  }
  const ArchiveSettings settings = ReadArchiveSettings(FLAGS_archive);
  const FoundArchive found = WalkArchive(FLAGS_archive, settings);
  RequireAnyLog(found, FLAGS_archive);
  std::vector<CheckedLog> checked;
  Progress progress("log");
  bool has_red = false;
  for (const FoundLog& log : found.logs) {
    progress.Show(static_cast<int>(checked.size()), static_cast<int>(found.logs.size()), "");
    CheckedLog one = {PathText(log.path), "", {}};
    try {
      if (log.is_recording) throw InputError("a recording: fathom_import comes first.");
      one.checkup = CheckUpByFlags(log.place);
      has_red |= HasRed(one.checkup);
    } catch (const InputError& error) {
      one.message = error.what();
    }
    // Its data are large, and no longer needed.
    one.checkup.log = {};
    for (DofCheckup& dof : one.checkup.dofs) dof.signals.reset();
    checked.push_back(std::move(one));
  }
  PrintText(stdout, FormatCheckedLogs(checked, TableForTerminal));
  return has_red ? kExitNoFit : kExitUsable;
}

int Run() {
  if (!FLAGS_velocity.empty()) {
    throw InputError("--velocity: the log's own files are checked, expected none.");
  }
  if (FLAGS_archive.empty() == FLAGS_log.empty()) {
    throw InputError("--log or --archive: expected one of them.");
  }
  return FLAGS_archive.empty() ? CheckLog() : CheckArchive();
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
