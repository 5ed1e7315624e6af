// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Scores the diagnosis on logs with hidden effects.
//
//   hidden_scores --jobs=2 --out=docs/diagnosis_scores.md
//   hidden_scores --logs=1 --sweep=all --oracle_cache=/tmp/oracle.txt
//   hidden_scores --only=thruster_lag,time_offset --logs=8 --list --oracle_cache=/tmp/oracle.txt

#include "fathom/base/files/output_file.h"
#include "fathom/log/write_log.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "log_plan.h"
#include "run_logs.h"
#include "score_board.h"
#include "scores_page.h"
#include "swept_rule.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>
#include <glog/logging.h>
#include <unistd.h>

DEFINE_int32(logs,
             8,
             "logs for each effect; 15 times as many with nothing hidden, 5 times as many "
             "with two effects and with one outside the catalogue");
DEFINE_uint64(seed, 1, "seed of everything that is drawn");
DEFINE_int32(jobs, 2, "logs at a time");
DEFINE_string(only,
              "",
              "separated by commas: names of effects hidden alone, of single logs "
              "(thruster_lag.3), 'nothing', 'one', 'two', 'unlisted'");
DEFINE_bool(list, false, "print every log with its verdict, as it is done");
DEFINE_string(out, "", "the page to write, Markdown");
DEFINE_string(oracle_cache, "", "file that keeps the oracle's answers from run to run");
DEFINE_string(
    sweep,
    "",
    "thresholds of the verdict or the search, separated by commas, or 'all': the logs are "
    "diagnosed with half and with twice of each, and those whose verdict or causes "
    "change are printed");
DEFINE_string(save, "", "folder to write the logs to instead of diagnosing them");

namespace fathom::hidden {
namespace {

std::vector<std::string> BetweenCommas(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream rest(text);
  for (std::string word; std::getline(rest, word, ',');) words.push_back(word);
  return words;
}

bool IsWanted(const LogPlan& plan, const std::string& only) {
  if (only.empty()) return true;
  for (const std::string& word : BetweenCommas(only)) {
    const std::string name = plan.Name();
    const std::string kind = plan.hidden == HiddenClass::kNothing      ? "nothing"
                             : plan.hidden == HiddenClass::kOneEffect  ? "one"
                             : plan.hidden == HiddenClass::kTwoEffects ? "two"
                                                                       : "unlisted";
    if (word == kind || word == name || name.substr(0, name.rfind('.')) == word) return true;
  }
  return false;
}

int Save(const std::vector<LogPlan>& plans) {
  for (const LogPlan& plan : plans) {
    const HiddenLog hidden = DrawHiddenLog(plan, FLAGS_seed);
    WriteLog(std::filesystem::path(FLAGS_save) / plan.Name(), hidden.log);
    std::printf("%s: %s\n", plan.Name().c_str(), hidden.truth.setup.c_str());
  }
  return 0;
}

// What a reader would see change.
bool IsSame(const LogScore& a, const LogScore& b) {
  return a.verdict == b.verdict && a.named == b.named;
}

// One line for each change of a threshold, and one for each log that it changes.
int Sweep(const std::vector<LogPlan>& plans, OracleCache& oracle) {
  const std::vector<std::string> known = SweptRules();
  const std::vector<std::string> names = FLAGS_sweep == "all" ? known : BetweenCommas(FLAGS_sweep);
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) != known.end()) continue;
    std::fprintf(stderr,
                 "hidden_scores: --sweep: %s is none of %s.\n",
                 name.c_str(),
                 fmt::format("{}", fmt::join(known, ", ")).c_str());
    return 1;
  }
  const auto run = [&](const DiagnosisOptions& options) {
    return RunLogs(plans, FLAGS_seed, FLAGS_jobs, oracle, options);
  };
  const auto print = [](const std::string& name, const std::vector<LogScore>& scores, int changed) {
    const ScoreBoard board = BoardOf(scores);
    std::printf("%-34s changed %2d of %zu; alone %d, wrong %d, false %d; %.2f s a log\n",
                name.c_str(),
                changed,
                scores.size(),
                board.separable_one.Of(Outcome::kAlone) + board.separable_two.Of(Outcome::kAlone),
                board.all_one.Of(Outcome::kWrong) + board.all_two.Of(Outcome::kWrong),
                board.false_causes,
                board.diagnosis_seconds / static_cast<double>(scores.size()));
    std::fflush(stdout);
  };
  const std::vector<LogScore> usual = run({});
  print("as it is", usual, 0);
  for (const std::string& name : names) {
    for (const double times : {0.5, 2.0}) {
      const std::vector<LogScore> scores = run(WithRule(name, times));
      std::vector<std::string> lines;
      for (std::size_t i = 0; i < scores.size(); ++i) {
        if (!IsSame(usual[i], scores[i])) lines.push_back("  " + Line(scores[i]));
      }
      print(fmt::format("{} x {}", name, times), scores, static_cast<int>(lines.size()));
      for (const std::string& line : lines) std::printf("%s\n", line.c_str());
    }
  }
  return 0;
}

int Run() {
  std::vector<LogPlan> plans =
      DrawPlans({15 * FLAGS_logs, FLAGS_logs, 5 * FLAGS_logs, 5 * FLAGS_logs}, FLAGS_seed);
  std::erase_if(plans, [](const LogPlan& plan) { return !IsWanted(plan, FLAGS_only); });
  if (plans.empty()) {
    std::fprintf(stderr, "hidden_scores: --only=%s fits no log.\n", FLAGS_only.c_str());
    return 1;
  }
  if (!FLAGS_save.empty()) return Save(plans);
  OracleCache oracle(FLAGS_oracle_cache);
  if (!FLAGS_sweep.empty()) return Sweep(plans, oracle);
  std::size_t num_done = 0;
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  const auto scores =
      RunLogs(plans, FLAGS_seed, FLAGS_jobs, oracle, {}, [&](const LogScore& score) {
        ++num_done;
        if (FLAGS_list) {
          std::printf("%s\n", Line(score).c_str());
          std::fflush(stdout);
        }
        if (is_terminal) std::fprintf(stderr, "\r%zu of %zu ", num_done, plans.size());
      });
  if (is_terminal) std::fprintf(stderr, "\n");
  std::printf("%s", Summary(scores).c_str());
  const ScoreBoard board = BoardOf(scores);
  std::printf("%zu logs; diagnosis %.1f s in all, %.2f s a log, slowest %.1f s; oracle %.0f s\n",
              scores.size(),
              board.diagnosis_seconds,
              board.diagnosis_seconds / static_cast<double>(scores.size()),
              board.slowest_diagnosis,
              board.oracle_seconds);
  if (FLAGS_out.empty()) return 0;
  std::string command = "hidden_scores";
  if (FLAGS_logs != 8) command += fmt::format(" --logs={}", FLAGS_logs);
  if (FLAGS_seed != 1) command += fmt::format(" --seed={}", FLAGS_seed);
  if (!FLAGS_only.empty()) command += " --only=" + FLAGS_only;
  WriteFile(FLAGS_out, ScoresPage(scores, command + " --out=docs/diagnosis_scores.md"));
  return 0;
}

}  // namespace
}  // namespace fathom::hidden

int main(int argc, char** argv) {
  gflags::SetUsageMessage("scores the diagnosis on logs with hidden effects");
  gflags::ParseCommandLineFlags(&argc, &argv, true);
  FLAGS_logtostderr = true;
  google::InitGoogleLogging(argv[0]);
  return fathom::hidden::Run();
}
