// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/print_imported.h"

#include "fathom/base/shell_word.h"
#include "fathom/findings/pose_twist_check.h"
#include "fathom/findings/stamp_check.h"
#include "fathom/open_log/survey.h"
#include "fathom/tool/print_findings.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

void PrintStream(const char* file, const std::optional<Stream>& stream) {
  if (!stream) return;
  fmt::print("{:<13}{} rows, t = {:.3f} to {:.3f} s\n",
             file,
             stream->time.size(),
             stream->time.front(),
             stream->time.back());
}

}  // namespace

void PrintStreams(const Log& log) {
  PrintStream("command.csv", log.command ? log.command : log.fins ? log.fins : log.shafts);
  PrintStream("velocity.csv", log.velocity);
  PrintStream("pose.csv", log.pose);
}

void PrintFirstLook(const std::filesystem::path& folder, const Log& log) {
  if ((log.command || log.fins || log.shafts) && !log.velocity && !log.pose && !log.video.empty()) {
    fmt::print("note: the motion is in the video. This tracks it: fathom_track --log={} --out={}\n",
               ShellWord(folder.string()),
               ShellWord(folder.string() + "_tracked"));
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
        ShellWord(folder.string()));
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
  fmt::print("next: fathom_check --log={}\n", ShellWord(folder.string()));
  std::fflush(stdout);
  PrintWarnings(findings);
}

}  // namespace fathom
