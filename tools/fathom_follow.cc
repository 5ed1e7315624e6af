// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The adaptive law on line: a sample on stdin, an estimate on stdout.

#include "fathom/adaptive/adaptive_follower.h"
#include "fathom/adaptive/follower_file.h"
#include "fathom/adaptive/usable_estimate.h"
#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/tool/adaptive_flags.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/estimate_history.h"
#include "fathom/tool/estimate_lines.h"
#include "fathom/tool/follow_page.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/sample_lines.h"
#include "fathom/tool/tool.h"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(
    state,
    "",
    "Go on from this file (JSON) if it is there, and write the state of the law to it: at "
    "the end, and as --state_every says.");
DEFINE_int32(state_every, 1000, "Write the state behind every so many samples.");
DEFINE_bool(json, false, "Print lines of JSON, an object each, instead of CSV.");

DEFINE_string(
    page,
    "",
    "Write the estimates over time to this HTML file, anew every --page_every seconds. An "
    "open page loads itself again.");
DEFINE_double(page_every, 2.0, "Write the page so often at most [s].");

DECLARE_string(dof);

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_follow",
    "Follows a stream by the adaptive law: lines t,tau,v on stdin, an estimate each on stdout.",
    "--dof=DOF --gains=a_m,l1,l2,l3,l4 [--integrator=runge_kutta|euler] [--state=FILE] "
    "[--state_every=SAMPLES] [--json] [--page=FILE.html]",
    "awk -F, 'FNR > 1 { k = int(10 * $1 + 1e-6) }\n"
    "         FNR > 1 && NR == FNR { tau[k] = $2 }\n"
    "         FNR > 1 && NR != FNR { print $1 \",\" tau[k] \",\" $2 }' \\\n"
    "    data/flatfish/command.csv data/flatfish/velocity.csv |\n"
    "    fathom_follow --dof=surge --gains=-1,1e-4,140,6,0.14",
    "A line holds a stamp [s], the force [N or N m] that holds from it on, and the measured "
    "velocity [m/s or rad/s]. The first line may name the columns; blank lines and comments (#) "
    "are passed over. Each line out is flushed: t, the four parameters, their scatter over the "
    "last third of the samples so far (_std), and usable, 1 where fathom_identify "
    "--family=adaptive would call the estimate usable. The law has no standard errors: "
    "docs/adaptive.md says what the scatter does not cover. Its cells are empty behind fewer than "
    "ten samples.\n"
    "--gains has to be given. fathom_identify --family=adaptive --model=FILE chooses gains from a "
    "log and writes them into the file: provenance, gains.\n"
    "A state file belongs to its --dof, --gains and --integrator. Where a line is refused, the "
    "state is that of the line before. A stream that begins anew, as tail -n +1 -F prints it, is "
    "passed over up to the last sample of the state.",
    {},
    {},
    "0: the last estimate is usable; 1: input or flags cannot be used; 2: the last estimate is not "
    "usable, or the law diverged"};

Dof RequireDof() {
  RequireFlag("dof", FLAGS_dof, "surge, sway, heave, roll, pitch or yaw");
  return *DofFromFlag();
}

AdaptiveOptions RequireOptions() {
  RequireFlag("gains", FLAGS_gains, "a_m,l1,l2,l3,l4: a stream cannot be searched for them");
  const AdaptiveOptions options = AdaptiveOptionsFromFlags();
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("--gains: {}.", fmt::join(problems, "; ")));
  }
  return options;
}

// A follower, what it reads and where its state goes.
class FollowedStream {
 public:
  FollowedStream(Dof dof, const AdaptiveOptions& options)
      : dof_(dof), options_(options), follower_(options), lines_("stdin", &std::cin) {
    std::error_code error;
    if (FLAGS_state.empty() || !std::filesystem::exists(FLAGS_state, error)) return;
    follower_ = ReadFollower(FLAGS_state, dof, options);
    const AdaptiveState& last = follower_.state();
    lines_.GoOnBehind({last.t, last.force, last.velocity}, FLAGS_state);
  }

  // The estimate behind the next sample; nothing at the end.
  std::optional<FollowedEstimate> Next() {
    const std::optional<SampleLine> sample = ReadOrSave();
    if (!sample) return std::nullopt;
    if (num_samples_++ == 0) TellWhatIsNotRead();
    return follower_.Add(sample->t, sample->force, sample->velocity);
  }

  void SaveIfDue() const {
    if (num_samples_ % FLAGS_state_every == 0) Save();
  }

  void Save() const {
    if (FLAGS_state.empty() || num_samples_ == 0) return;
    WriteFile(FLAGS_state, FormatFollower(dof_, options_, follower_));
  }

  bool has_samples() const { return num_samples_ > 0; }
  bool has_passed_over_all() const { return num_samples_ == 0 && lines_.num_passed_over() > 0; }

 private:
  void TellWhatIsNotRead() const {
    if (!lines_.not_read().empty()) {
      PrintText(stderr,
                fmt::format("stdin: further columns are not read: {}.\n",
                            fmt::join(lines_.not_read(), ", ")));
    }
    if (lines_.num_passed_over() > 0) {
      PrintText(stderr,
                fmt::format("stdin: {} passed over, up to the last one of {}.\n",
                            Plural(static_cast<std::size_t>(lines_.num_passed_over()), "sample"),
                            FLAGS_state));
    }
  }

  // What was taken before a line that cannot be used is kept.
  std::optional<SampleLine> ReadOrSave() {
    try {
      return lines_.Next();
    } catch (const InputError&) {
      Save();
      throw;
    }
  }

  Dof dof_;
  AdaptiveOptions options_;
  AdaptiveFollower follower_;
  SampleLines lines_;
  long num_samples_ = 0;  // of this run
};

// The page of a stream, while it goes on.
class GrowingPage {
 public:
  GrowingPage(Dof dof, const AdaptiveOptions& options)
      : dof_(dof), options_(options), origin_(OriginOfPage({})) {}

  void Add(const FollowedEstimate& estimate) {
    if (FLAGS_page.empty()) return;
    history_.Add(estimate);
    const auto now = std::chrono::steady_clock::now();
    if (now < due_) return;
    Write(FLAGS_page_every);
    due_ = now + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                     std::chrono::duration<double>(FLAGS_page_every));
  }

  // The stream has ended: the page stands still from now on.
  void Finish() const {
    if (!FLAGS_page.empty() && !history_.IsEmpty()) Write(0.0);
  }

 private:
  void Write(double reload_after) const {
    Page page = FollowPage(history_, dof_, options_);
    page.origin = origin_;
    page.reload_after = reload_after;
    WriteFile(FLAGS_page, RenderPage(page));
  }

  Dof dof_;
  AdaptiveOptions options_;
  PageOrigin origin_;
  EstimateHistory history_;
  std::chrono::steady_clock::time_point due_ = {};
};

// The next estimate. Where a line is refused, the page too tells what came before it.
std::optional<FollowedEstimate> NextOf(FollowedStream* stream, const GrowingPage& page) {
  try {
    return stream->Next();
  } catch (const InputError&) {
    page.Finish();
    throw;
  }
}

// False where nobody reads any more.
bool Print(const std::string& line) {
  std::fputs(line.c_str(), stdout);
  return std::fflush(stdout) == 0;
}

std::string WhyLastIsUnusable(const FollowedEstimate& last) {
  if (std::isnan(last.std[kInertia])) return "There are fewer than ten samples.";
  return WhyUnusable(last.model, last.std[kInertia]);
}

int Run() {
  const Dof dof = RequireDof();
  const AdaptiveOptions options = RequireOptions();
  if (FLAGS_state_every < 1) {
    throw InputError(
        fmt::format("--state_every: is {}, expected at least 1 sample.", FLAGS_state_every));
  }
  constexpr double kLongestWait = 86400.0;  // [s]
  if (!(FLAGS_page_every > 0.0 && FLAGS_page_every <= kLongestWait)) {
    throw InputError(fmt::format("--page_every: is {}, expected more than 0 s, up to {:g} s.",
                                 FLAGS_page_every,
                                 kLongestWait));
  }
  RequireOutputs({{"state", FLAGS_state}, {"page", FLAGS_page}}, {});
  FollowedStream stream(dof, options);
  GrowingPage page(dof, options);
  if (!FLAGS_json) Print(EstimateCsvHeader());
  FollowedEstimate last;
  while (const auto estimate = NextOf(&stream, page)) {
    last = *estimate;
    if (std::isnan(last.model.inertia)) {
      page.Finish();
      PrintText(stderr,
                fmt::format("fathom_follow: no usable model: The adaptive law diverged at t = {}: "
                            "the step is too long for these gains.\n",
                            last.t));
      return kExitNoFit;
    }
    if (!Print(FLAGS_json ? EstimateJsonLine(last, dof) : EstimateCsvLine(last))) break;
    stream.SaveIfDue();
    page.Add(last);
  }
  if (stream.has_passed_over_all()) {
    throw InputError(fmt::format("stdin: holds no sample behind the last one of {}.", FLAGS_state));
  }
  if (!stream.has_samples()) throw InputError("stdin: holds no sample, expected lines t,tau,v.");
  stream.Save();
  page.Finish();
  if (last.usable) return kExitUsable;
  PrintText(stderr, "fathom_follow: no usable model: " + WhyLastIsUnusable(last) + "\n");
  return kExitNoFit;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run);
}
