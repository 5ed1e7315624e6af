// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/caveats.h"

#include "fathom/base/interval95.h"
#include "fathom/least_squares/least_squares.h"
#include "fathom/report/format_value.h"
#include "fathom/signal/filters/dominant_tone.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// A command whose strongest line carries this share of its variance is a single sine to the fit.
constexpr double kSingleTone = 0.8;

// An inertia that an unknown delay leaves so well known is not mistaken for one.
constexpr double kStillKnown = 0.01;

// An interval so many times the inertia says nothing but that there is none.
constexpr double kBeyondMeaning = 1e3;

double HalfWidth(const ParameterCovariance& covariance, int index) {
  return kStdsOf95 * std::sqrt(covariance(index, index));
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
      return "Fast and large changes of the command determine it: steps, or a square wave with a "
             "period of 10 to 20 s.";
    case kQuadraticDamping:
      return "Steady runs at several speeds up to the highest determine it.";
    case kLinearDamping:
      return "Slow steady runs and coasting to rest determine it.";
    default:
      return "A pause at rest with the command held determines it.";
  }
}

void DescribeDamping(int index, OutputErrorSummary* summary) {
  const std::string caveat = summary->on_bound[index]
                                 ? CaveatOnBound(index, HalfWidth(summary->covariance, index))
                                 : CaveatOnDamping(index,
                                                   ToVector(summary->model)[index],
                                                   std::sqrt(summary->covariance(index, index)));
  if (!caveat.empty()) summary->caveats.push_back(caveat);
}

// Under a single sine a delay of the command turns the response like inertia against damping.
void DescribeDelay(std::span<const Segment> segments, OutputErrorSummary* summary) {
  const ParameterEvidence& evidence = summary->evidence;
  const double share = evidence.share[kInertia];
  if (!(evidence.share_with_time_offset[kInertia] < kLostToDelay * share)) return;
  const auto longest =
      std::max_element(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
        return a.time.back() - a.time.front() < b.time.back() - b.time.front();
      });
  std::string caveat = CaveatOnDelay(
      longest->command.Between(longest->time.front(), longest->time.back()),
      {.inertia = summary->model.inertia,
       .inertia_per_second = evidence.change_per_second_of_offset[kInertia],
       .linear_damping_per_second = evidence.change_per_second_of_offset[kLinearDamping],
       .half_width = HalfWidth(summary->covariance, kInertia),
       .half_width_with_delay = HalfWidth(evidence.covariance_with_time_offset, kInertia)});
  summary->delay_is_open = !caveat.empty();
  if (summary->delay_is_open) summary->caveats.push_back(std::move(caveat));
}

// A residual of the position that wanders has no stationary colour, which the covariance takes it
// to have: docs/output_error.md, "What it gains". Measured: 0.976 and more between neighbours under
// a force of the water, at 10 Hz, 0.03 of a white sensor.
void DescribeWandering(OutputErrorSummary* summary) {
  constexpr double kWanders = 0.9;
  const double correlation = summary->evidence.noise_correlation;
  if (!(correlation > kWanders)) return;
  summary->caveats.push_back(fmt::format(
      "The residual of the position wanders: its neighbours have a correlation of {:.3f}. The "
      "intervals are then too short, that of the buoyancy by up to a factor of 4. "
      "--weighting=learned gives intervals that allow for it.",
      correlation));
}

std::string TwoDigits(double value) {
  if (value == 0.0 || !std::isfinite(value)) return fmt::format("{}", value);
  return RoundedAt(value, 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
}

// What a wrong sign looks like to least squares; empty where the sign is right or cannot be told.
// Output error cannot reach a negative inertia: it ends at one without any motion.
std::string WhyOfWrongSign(std::span<const Segment> segments) {
  const LeastSquaresSummary least_squares = FitLeastSquares(segments);
  return least_squares.has_wrong_sign ? least_squares.message : "";
}

}  // namespace

std::string CaveatOnDamping(int parameter, double value, double std) {
  if (!(kStdsOf95 * std > value)) return "";
  const std::string interval =
      std::isfinite(std)
          ? fmt::format("its 95 % interval, {}, is wider than ± 100 % of its value",
                        FormatInterval(value, std, kParameterInfo[parameter].lower_bound))
          : std::string("any value fits");
  return fmt::format("This log does not determine {}: {}. {}",
                     Spaced(kParameterInfo[parameter].name),
                     interval,
                     ExperimentFor(parameter));
}

std::string CaveatOnDelay(const HeldCommand& command, const DelayDoubt& doubt) {
  const Tone tone = DominantTone(command);
  const bool is_sine = tone.share >= kSingleTone;
  if (!is_sine && doubt.half_width_with_delay < kStillKnown * doubt.inertia) return "";
  const bool is_known = std::isfinite(doubt.half_width_with_delay);
  const std::string change = fmt::format(
      "The values hold only if there is no delay. One second of delay would change the inertia by "
      "{} and the linear damping by {}. With an unknown delay the inertia {}.",
      TwoDigits(doubt.inertia_per_second),
      TwoDigits(doubt.linear_damping_per_second),
      is_known ? fmt::format("is known to ± {} and not to ± {} (95 %)",
                             TwoDigits(doubt.half_width_with_delay),
                             TwoDigits(doubt.half_width))
               : std::string("is not determined"));
  if (!is_sine && is_known) {
    return change +
           " Run fathom_diagnose on this log: it looks for a delay of the command (time_offset).";
  }
  return fmt::format(
      "This log cannot separate inertia, damping and a command delay{}. {} To separate them, "
      "use a square wave with a period of 10 to 20 s, or several tones up to 1.5 rad/s.",
      is_sine
          ? fmt::format(", because its command is a single sine of {:.2g} rad/s", tone.frequency)
          : "",
      change);
}

std::string CaveatOnBound(int parameter, double half_width) {
  return fmt::format("{} is at its bound 0: these data show none (below {:.2g} with 95 %).",
                     Spaced(kParameterInfo[parameter].name),
                     half_width);
}

void DescribeEvidence(std::span<const Segment> segments,
                      FittedOutput output,
                      OutputErrorSummary* summary) {
  const double inertia = summary->model.inertia;
  const double half_width = HalfWidth(summary->covariance, kInertia);
  summary->determined = half_width < inertia;
  if (!summary->determined) {
    summary->message = WhyOfWrongSign(segments);
    if (!summary->message.empty()) return;
    summary->message =
        half_width < kBeyondMeaning * inertia
            ? fmt::format(
                  "these data do not determine the inertia: its 95 % interval is {}. {}",
                  FormatInterval(
                      inertia, half_width / kStdsOf95, kParameterInfo[kInertia].lower_bound),
                  ExperimentFor(kInertia))
            : fmt::format(
                  "these data do not determine the model: some combination of the parameters has "
                  "no effect on the motion. {}",
                  ExperimentFor(kInertia));
    return;
  }
  summary->message = fmt::format("converged after {} iterations.", summary->num_iterations);
  DescribeDamping(kQuadraticDamping, summary);
  DescribeDamping(kLinearDamping, summary);
  DescribeDelay(segments, summary);
  if (output == FittedOutput::kPosition) DescribeWandering(summary);
}

}  // namespace fathom
