// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/caveats.h"

#include "fathom/signal/excitation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNormal95 = 1.96;

// A command whose strongest line carries this share of its variance is a single sine to the fit.
constexpr double kSingleTone = 0.8;

// A parameter that loses this much of its share once a time offset is admitted cannot be told from
// one. Measured: single sines lose three quarters, steps and several tones less than a third.
constexpr double kLostToOffset = 0.5;

// Below this share the other parameters imitate a parameter almost wholly.
constexpr double kSmallShare = 0.3;

double HalfWidth(const ParameterCovariance& covariance, int index) {
  return kNormal95 * std::sqrt(covariance(index, index));
}

std::string Spaced(const char* name) {
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

// Which experiment would determine the parameter.
const char* ExperimentFor(int index) {
  switch (index) {
    case kInertia:
      return "Commands that change fast and by much would: steps, or a square wave of 10 to 20 s.";
    case kQuadraticDamping:
      return "Steady runs at several speeds up to the highest would.";
    case kLinearDamping:
      return "Slow steady runs and coasting to rest would.";
    default:
      return "A pause at rest with the command held would.";
  }
}

void DescribeDamping(int index, OutputErrorSummary* summary) {
  const double value = ToVector(summary->model)[index];
  const double half_width = HalfWidth(summary->covariance, index);
  const std::string name = Spaced(kParameterInfo[index].name);
  if (summary->on_bound[index]) {
    summary->caveats.push_back(CaveatOnBound(index, half_width));
    return;
  }
  if (!(half_width > value)) return;
  const double share = summary->evidence.share[index];
  const std::string reason =
      share < kSmallShare
          ? fmt::format("only {:.0f} % of its signature is not imitated by the other parameters",
                        100.0 * share)
          : std::string("it hides in the noise");
  summary->caveats.push_back(
      fmt::format("This log does not determine {}: {:.3g} +- {:.2g} (95 %), since {}. {}",
                  name,
                  value,
                  half_width,
                  reason,
                  ExperimentFor(index)));
}

// The strongest line of what was commanded during the segment.
Tone ToneOf(const Segment& segment) {
  HeldCommand command;
  for (size_t i = 0; i < segment.command.time.size(); ++i) {
    const double t = segment.command.time[i];
    if (t < segment.time.front() || t > segment.time.back()) continue;
    command.time.push_back(t);
    command.value.push_back(segment.command.value[i]);
  }
  if (command.time.size() < 2) return {};
  return DominantTone(command, command.time.back() - command.time.front());
}

// Under a single sine a delay of the command turns the response like inertia against damping.
void DescribeTimeOffset(std::span<const Segment> segments, OutputErrorSummary* summary) {
  const ParameterEvidence& evidence = summary->evidence;
  const double share = evidence.share[kInertia];
  const double share_with_offset = evidence.share_with_time_offset[kInertia];
  if (!(share_with_offset < kLostToOffset * share)) return;
  const auto longest =
      std::max_element(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
        return a.time.back() - a.time.front() < b.time.back() - b.time.front();
      });
  const Tone tone = ToneOf(*longest);
  const std::string input = tone.share >= kSingleTone
                                ? fmt::format("its single sine of {:.2g} rad/s", tone.frequency)
                                : std::string("its slow command");
  const double with_offset = HalfWidth(evidence.covariance_with_time_offset, kInertia);
  const std::string known = std::isfinite(with_offset)
                                ? fmt::format("is known to +- {:.2g}, not +- {:.2g} (95 %)",
                                              with_offset,
                                              HalfWidth(summary->covariance, kInertia))
                                : std::string("is not known at all");
  summary->caveats.push_back(fmt::format(
      "Inertia, damping and a delay of the command cannot be separated in this log under {}: the "
      "values hold if there is no delay. One second of delay would change the inertia by {:.2g}, "
      "the linear damping by {:.2g}; with the delay unknown the inertia {}. A square wave of 10 to "
      "20 s, or several tones up to 1.5 rad/s, would decide.",
      input,
      evidence.change_per_second_of_offset[kInertia],
      evidence.change_per_second_of_offset[kLinearDamping],
      known));
}

}  // namespace

std::string CaveatOnBound(int parameter, double half_width) {
  return fmt::format(
      "{} ended on its bound 0: these data show none of it (below {:.2g} with 95 %).",
      Spaced(kParameterInfo[parameter].name),
      half_width);
}

void DescribeEvidence(std::span<const Segment> segments, OutputErrorSummary* summary) {
  const double inertia = summary->model.inertia;
  const double half_width = HalfWidth(summary->covariance, kInertia);
  summary->determined = half_width < inertia;
  if (!summary->determined) {
    summary->message =
        std::isfinite(half_width)
            ? fmt::format("this log does not determine the inertia: {:.4g} +- {:.2g} (95 %). {}",
                          inertia,
                          half_width,
                          ExperimentFor(kInertia))
            : fmt::format(
                  "this log does not determine the model: some combination of the "
                  "parameters leaves no trace in the motion. {}",
                  ExperimentFor(kInertia));
    return;
  }
  summary->message = fmt::format("converged after {} iterations.", summary->num_iterations);
  DescribeDamping(kQuadraticDamping, summary);
  DescribeDamping(kLinearDamping, summary);
  DescribeTimeOffset(segments, summary);
}

}  // namespace fathom
