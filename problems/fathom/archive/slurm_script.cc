// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/slurm_script.h"

#include "fathom/archive/jobs/log_jobs.h"
#include "fathom/base/input_error.h"
#include "fathom/base/shell_word.h"

#include <fmt/format.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

std::string FlagsOf(const BatchOptions& options) {
  std::string flags = fmt::format("--jobs={} --time_limit={} --memory_limit={} --diagnose={}",
                                  options.jobs,
                                  options.time_limit,
                                  options.memory_limit,
                                  options.diagnose);
  if (!options.families.empty()) flags += " --families=" + ShellWord(options.families);
  if (!options.weighting.empty()) flags += " --weighting=" + ShellWord(options.weighting);
  if (const auto& dofs = options.coupled_dofs) {
    flags += " --dofs=" + (dofs->empty() ? "auto" : JoinedNames(*dofs));
  }
  flags += " --tools=" + ShellWord(fs::absolute(options.tools).string());
  return flags;
}

}  // namespace

std::string SlurmScript(const BatchOptions& options,
                        int num_parts,
                        const fs::path& report,
                        const fs::path& csv) {
  if (num_parts < 1 || num_parts > 10000) {
    throw InputError(fmt::format("--plan: is {}, expected 1 to 10000 parts.", num_parts));
  }
  // Room for the parent and the file cache beside the programs.
  const double memory = options.jobs * options.memory_limit + 500.0;
  const auto flag = [](const char* name, const fs::path& file) {
    if (file.empty()) return std::string();
    return fmt::format(" --{}={}", name, ShellWord(fs::absolute(file).string()));
  };
  const std::string last_flags = flag("report", report) + flag("csv", csv);
  return fmt::format(
      R"(#!/bin/bash
#SBATCH --job-name=fathom
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={jobs}
#SBATCH --mem={memory:.0f}M
#SBATCH --requeue
# Written by fathom_batch --slurm. A task whose node dies is queued again. On the same node it goes
# on where it was, on another one it starts anew.
set -euo pipefail
batch={batch}
archive={archive}
results={results}
parts={parts}
flags=({flags})

if [[ "${{1:-}}" == merge ]]; then
  merge=()
  for ((i = 0; i < parts; ++i)); do merge+=("--merge=$results.part$i"); done
  "$batch" --archive="$archive" --results="$results" "${{merge[@]}}" "${{flags[@]}}"{last_flags}
  rm -f "$results".part*.copy.*  # of tasks that were killed while they copied
  if [[ -d "$results.logs" ]]; then rmdir --ignore-fail-on-non-empty "$results.logs"; fi
  exit
fi
i=$SLURM_ARRAY_TASK_ID
# TMPDIR may be that of the machine that submitted the job.
disk=${{TMPDIR:-/tmp}}
if [[ ! -d "$disk" || ! -w "$disk" ]]; then disk=/tmp; fi
local="$disk/fathom_${{SLURM_ARRAY_JOB_ID}}_$i"
mkdir -p "$local"
# The merge needs the logs that were made of images and recordings.
mkdir -p "$results.logs"
ln -sfn "$results.logs" "$local/part.sqlite.logs"
"$batch" --archive="$archive" --results="$local/part.sqlite" --merge="$results" --shard="$i/$parts" "${{flags[@]}}"
# Where Slurm only believes that a node is dead, two of the same task may end at the same time.
copy=$results.part$i.copy.$SLURM_JOB_ID.${{SLURM_RESTART_COUNT:-0}}
cp "$local/part.sqlite" "$copy"
mv "$copy" "$results.part$i"
rm -rf "$local"
)",
      fmt::arg("jobs", options.jobs),
      fmt::arg("memory", memory),
      fmt::arg("batch", ShellWord(fs::absolute(options.tools / "fathom_batch").string())),
      fmt::arg("archive", ShellWord(fs::absolute(options.archive).string())),
      fmt::arg("results", ShellWord(fs::absolute(options.results).string())),
      fmt::arg("parts", num_parts),
      fmt::arg("flags", FlagsOf(options)),
      fmt::arg("last_flags", last_flags));
}

std::string HowToSubmit(const fs::path& script, int num_parts) {
  return fmt::format(
      "Submit it:\n"
      "  job=$(sbatch --parsable --array=0-{0} {1})\n"
      "  sbatch --dependency=afterok:$job {1} merge\n",
      num_parts - 1,
      ShellWord(script.string()));
}

}  // namespace fathom
