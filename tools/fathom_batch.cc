// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Every log of an archive identified and diagnosed, every dive compared with the others.

#include "fathom/archive/batch.h"
#include "fathom/archive/batch_text.h"
#include "fathom/archive/report/archive_page.h"
#include "fathom/archive/slurm_script.h"
#include "fathom/archive/store/store.h"
#include "fathom/base/dof.h"
#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/identification/family.h"
#include "fathom/open_log/survey.h"
#include "fathom/output_error/weighting.h"
#include "fathom/tool/default_vehicle_flag.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/flag_values.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/programs_folder.h"
#include "fathom/tool/progress.h"
#include "fathom/tool/progress_lines.h"
#include "fathom/tool/tool.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>
#include <unistd.h>

DEFINE_string(archive, "", "A folder with logs in it, at any depth. Nothing is written into it.");
DEFINE_string(results, "", "An SQLite database; made if it is missing, continued if it is there.");
DEFINE_int32(jobs, 0, "Programs to run at a time. 0: one for each core.");
DEFINE_string(report, "", "Write a page to this HTML file.");
DEFINE_bool(pages, false, "Write a page for each diagnosis too, into a folder beside --report.");
DEFINE_string(csv, "", "Write the table `fits` to this CSV file.");
DEFINE_string(
    families,
    "",
    "Comma-separated, as in fathom_compare: least_squares, adaptive, output_error, joint. "
    "Default: all that a log allows.");
DEFINE_string(weighting,
              "plain",
              "Of output error, as in fathom_identify: plain, or learned where the water moved the "
              "vehicle.");
DEFINE_bool(diagnose, true, "Diagnose every log (fathom_diagnose).");
DEFINE_string(dofs,
              "",
              "One coupled model of each log too, as fathom_diagnose --dofs: surge,sway,yaw, or "
              "auto: of the DOFs that the log moves. Default: none.");
DEFINE_double(time_limit, 600.0, "Of each program [s].");
DEFINE_double(memory_limit, 2000.0, "Of each program [MB].");
DEFINE_bool(strict, false, "Exit with code 3 if a log failed.");
DEFINE_bool(rehash, false, "Read also the files whose size and time of change are as before.");
DEFINE_bool(dry_run, false, "Say what would be done, and run nothing.");
DEFINE_string(shard, "", "i/N: do only part i, from 0 on, of N; of single logs alone.");
DEFINE_string(merge,
              "",
              "Results of other batches on this archive, comma-separated, to begin with.");
DEFINE_int32(plan, 0, "With --slurm: in how many parts.");
DEFINE_string(slurm, "", "Hash the logs and write a job script for a Slurm cluster to this file.");
DEFINE_string(tools, "", "The folder of Fathom's programs. Default: that of this program.");
DEFINE_string(survey, "", "Print what this log can identify, as JSON, and do nothing else.");

namespace fathom {
namespace {

namespace fs = std::filesystem;

const ToolInfo kInfo = {
    "fathom_batch",
    "Reprocesses an archive: every log identified and diagnosed, every dive compared with the "
    "others.",
    "--archive=DIR --results=FILE [--jobs=N] [--dofs=DOF,DOF...|auto] [--report=FILE] "
    "[--pages] [--csv=FILE] [--strict]",
    "data/examples/example_archive.sh dives\n"
    "  fathom_batch --archive=dives --results=dives.sqlite --report=dives.html --jobs=2",
    "Each log goes through fathom_compare and fathom_diagnose, with --dofs also as one coupled "
    "model, all logs of a dive through one "
    "fathom_identify. A rerun does only what is new or changed. A log that fails costs no other "
    "one: the summary says which and why. The tables and archive.yaml: docs/archive.md. Many "
    "machines: docs/cluster.md. Exit code 3: a log failed and --strict is given.",
    {"merge"}};

// "3/8"
Shard ParseShard(const std::string& text) {
  Shard shard;
  char end = 0;
  if (std::sscanf(text.c_str(), "%d/%d%c", &shard.index, &shard.count, &end) != 2) {
    throw InputError(fmt::format("--shard: is '{}', expected i/N as 0/8.", text));
  }
  return shard;
}

fs::path ToolsFolder() {
  if (FLAGS_tools.empty()) return ProgramsFolder();
  if (fs::exists(fs::path(FLAGS_tools) / "fathom_compare")) return FLAGS_tools;
  throw InputError(
      fmt::format("--tools={}: holds no fathom_compare, expected the folder of Fathom's programs.",
                  FLAGS_tools));
}

// What a log does not say itself, an archive says for its logs.
void RequireNoFlagsOfOneLog() {
  for (const auto& [flag, key] :
       {std::pair{"dof", "dof"}, std::pair{"default_vehicle", "vehicle"}}) {
    if (gflags::GetCommandLineFlagInfoOrDie(flag).is_default) continue;
    throw InputError(fmt::format(
        "--{}: is of one log, expected none. `{}:` in archive.yaml holds for the logs of "
        "an archive that do not say it themselves.",
        flag,
        key));
  }
}

// "dives_pages" beside "dives.html".
fs::path PagesFolder() {
  if (!FLAGS_pages) return {};
  RequireFlag("report", FLAGS_report, "a page for --pages to stand beside");
  const fs::path report = FLAGS_report;
  return report.parent_path() / (report.stem().string() + "_pages");
}

int NumCores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

std::optional<std::vector<Dof>> CoupledDofsFromFlag() {
  if (FLAGS_dofs.empty()) return std::nullopt;
  std::vector<Dof> dofs;
  if (FLAGS_dofs == "auto") return dofs;
  for (const std::string& name : SplitAtCommas(FLAGS_dofs)) {
    dofs.push_back(ParseFlag("dofs", name, ParseDof));
  }
  std::ranges::sort(dofs);
  if (const auto twice = std::ranges::adjacent_find(dofs); twice != dofs.end()) {
    throw InputError(fmt::format("--dofs: names {} twice, expected each once.", Name(*twice)));
  }
  if (dofs.size() < 2) {
    throw InputError(fmt::format("--dofs: is {}, expected two or more as surge,sway,yaw, or auto.",
                                 Quoted(FLAGS_dofs)));
  }
  return dofs;
}

BatchOptions OptionsFromFlags() {
  RequireNoFlagsOfOneLog();
  BatchOptions options;
  options.archive = RequireFlag("archive", FLAGS_archive, "a folder with logs");
  options.results = RequireFlag("results", FLAGS_results, "a database to write");
  options.tools = ToolsFolder();
  options.version = FATHOM_VERSION;
  for (const std::string& family : SplitAtCommas(FLAGS_families)) {
    ParseFlag("families", family, ParseFamily);
  }
  options.families = FLAGS_families;
  if (ParseFlag("weighting", FLAGS_weighting, ParseWeighting) == Weighting::kLearned) {
    options.weighting = FLAGS_weighting;
  }
  options.diagnose = FLAGS_diagnose;
  options.coupled_dofs = CoupledDofsFromFlag();
  options.jobs = FLAGS_jobs > 0 ? FLAGS_jobs : NumCores();
  options.time_limit = FLAGS_time_limit;
  options.memory_limit = FLAGS_memory_limit;
  options.rehash = FLAGS_rehash;
  options.pages = PagesFolder();
  if (!FLAGS_shard.empty()) options.shard = ParseShard(FLAGS_shard);
  for (const std::string& file : PathsInValues(FLAGS_merge)) options.merge.push_back(file);
  return options;
}

// "log 3 of 17, 2.1 a minute, 7 min left"
std::string LineOf(const BatchProgress& progress, double seconds) {
  return fmt::format(
      "{} {} of {}{}", progress.noun, progress.done, progress.total, PaceText(progress, seconds));
}

// In a terminal one line that changes, elsewhere a line a minute.
BatchSummary RunBatchWithProgress(const BatchOptions& options) {
  std::optional<Progress> line;
  std::optional<ProgressLines> lines;
  if (isatty(STDERR_FILENO) != 1) {
    lines.emplace(kInfo.name, "no log is done yet", std::chrono::minutes(1));
  }
  std::string noun;
  auto start = std::chrono::steady_clock::now();
  return RunBatch(options, [&](const BatchProgress& progress) {
    if (progress.noun != noun) {
      noun = progress.noun;
      if (!lines) line.emplace(noun);
      start = std::chrono::steady_clock::now();
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (lines) {
      lines->Show(LineOf(progress, seconds.count()));
      return;
    }
    line->Show(static_cast<int>(progress.done),
               static_cast<int>(progress.total),
               PaceText(progress, seconds.count()));
  });
}

int Run() {
  if (!FLAGS_survey.empty()) {
    fmt::print("{}",
               FormatSurvey(SurveyLog(FLAGS_survey, DofFromFlag(), DefaultVehicleFromFlag())));
    return kExitUsable;
  }
  const BatchOptions options = OptionsFromFlags();
  for (const auto& [flag, file] : {std::pair{"report", FLAGS_report},
                                   std::pair{"csv", FLAGS_csv},
                                   std::pair{"slurm", FLAGS_slurm}}) {
    RequireOutsideArchive(flag, file, options.archive);
    if (!file.empty()) RequireWritableFile(file);
  }
  if (FLAGS_dry_run || !FLAGS_slurm.empty()) {
    const BatchPlan plan = PlanBatch(options);
    fmt::print("{}", FormatPlan(plan, options.version));
    if (!FLAGS_slurm.empty()) {
      WriteFile(FLAGS_slurm, SlurmScript(options, FLAGS_plan, FLAGS_report, FLAGS_csv));
      fmt::print("\n{}", HowToSubmit(FLAGS_slurm, FLAGS_plan));
    }
    return kExitUsable;
  }
  const BatchSummary summary = RunBatchWithProgress(options);
  fmt::print("{}", FormatSummary(summary, ReadSummary(options.results)));
  if (!FLAGS_csv.empty()) WriteFile(FLAGS_csv, FormatFitsCsv(ReadResults(options.results).fits));
  if (!FLAGS_report.empty()) {
    WriteFile(FLAGS_report,
              RenderArchivePage(
                  ReportOf(options, summary, ReadResults(options.results), OriginOfPage({}))));
  }
  const bool failed = std::ranges::any_of(
      summary.states, [](const auto& state) { return IsFailure(state.first) && state.second > 0; });
  return FLAGS_strict && failed ? kExitStrict : kExitUsable;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
