// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/log_prediction.h"

#include "fathom/base/input_error.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/signal/signals.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/signal/split_at_gaps.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/free_run.h"
#include "fathom/simulate/prediction.h"
#include "fathom/simulate/run_start.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

void RequireUnitOf(const FittedModel& model, const Log& log) {
  const std::string unit = CommandUnitOf(log, model.dof);
  if (unit == model.force_unit) return;
  throw InputError(
      fmt::format("{}: its commands are in {}, but the model was identified from commands in {}: "
                  "expected the same unit.",
                  log.path.string(),
                  unit,
                  model.force_unit));
}

// A stretch of the log, to be run over.
struct Stretch {
  LogPart part = LogPart::kTrain;
  Segment segment;
  double position = 0.0;  // at its start, where the segment has none [m] or [rad]
};

// Of velocity.csv: from the first command on as SignalsOf() cuts, and what lies before.
std::vector<Stretch> StretchesOf(const Log& log, Dof dof, const HeldCommand& command) {
  const std::vector<double>& time = log.velocity->time;
  const std::vector<double>& measured = *log.velocity->Find(VelocityColumn(dof));
  const auto first =
      static_cast<std::size_t>(std::ranges::lower_bound(time, command.time.front()) - time.begin());
  const std::vector<double> way = WayAlong(time, measured, first);
  std::vector<Stretch> stretches;
  const auto add = [&](const SampleRange& range, LogPart part) {
    Stretch& stretch = stretches.emplace_back();
    stretch.part = part;
    const auto begin = static_cast<std::ptrdiff_t>(range.begin);
    const auto end = static_cast<std::ptrdiff_t>(range.end);
    stretch.segment.time.assign(time.begin() + begin, time.begin() + end);
    stretch.segment.velocity.assign(measured.begin() + begin, measured.begin() + end);
    stretch.segment.command = command.Between(time[range.begin], time[range.end - 1]);
    stretch.position = log.pose && TellsMotion(*log.pose, dof)
                           ? PositionAt(log, dof, time[range.begin])
                           : way[range.begin];
  };
  for (const SampleRange& range : SplitAtGaps(std::span(time).first(first))) {
    add(range, LogPart::kOutside);
  }
  for (const SampleRange& range : SplitAtGaps(time, log.held_out, first)) {
    const bool is_short = range.size() < kFewestOfSegment;
    add(range,
        is_short            ? LogPart::kOutside
        : range.is_held_out ? LogPart::kHeldOut
                            : LogPart::kTrain);
  }
  return stretches;
}

// Of the poses.
std::vector<Stretch> StretchesOf(const Log& log, Dof dof) {
  Signals signals = SignalsOf(log, dof, {.source = Source::kCamera});
  std::vector<Stretch> stretches;
  for (Segment& segment : signals.train) {
    stretches.push_back({LogPart::kTrain, std::move(segment)});
  }
  for (Segment& segment : signals.held_out) {
    stretches.push_back({LogPart::kHeldOut, std::move(segment)});
  }
  std::ranges::sort(
      stretches, {}, [](const Stretch& stretch) { return stretch.segment.time.front(); });
  for (Stretch& stretch : stretches) {
    stretch.position = PositionAt(log, dof, stretch.segment.time.front());
  }
  return stretches;
}

// A run from rest over the command, where no motion was measured.
std::optional<LogPrediction> FromRest(const ExtendedModel& model,
                                      HeldCommand command,
                                      const EffectInputs* inputs) {
  Segment segment;
  segment.time = command.time;
  segment.command = std::move(command);
  segment.velocity.assign(segment.time.size(), std::numeric_limits<double>::quiet_NaN());
  auto predicted = Predict(model, segment, {}, inputs);
  if (!predicted) return std::nullopt;
  LogPrediction prediction;
  prediction.segments.push_back(std::move(segment));
  prediction.parts.push_back(LogPart::kOutside);
  prediction.velocity.push_back(*std::move(predicted));
  return prediction;
}

}  // namespace

std::optional<LogPrediction> PredictLog(const FittedModel& fitted, const Log& log) {
  RequireUnitOf(fitted, log);
  const ExtendedModel model = fitted.Extended();
  const HeldCommand command = CommandOf(log, fitted.dof);
  EffectInputs inputs;
  if (!model.effects.empty()) {
    inputs = EffectInputsOf(log, fitted.dof);
    RequirePartners(model, inputs, log);
  }
  const bool has_velocity =
      log.velocity && log.velocity->Find(VelocityColumn(fitted.dof)) != nullptr;
  const EffectInputs* const needed = model.effects.empty() ? nullptr : &inputs;
  if (!has_velocity && !log.pose) return FromRest(model, command, needed);
  LogPrediction prediction;
  FigureSums all, train, held_out;
  for (Stretch& stretch :
       has_velocity ? StretchesOf(log, fitted.dof, command) : StretchesOf(log, fitted.dof)) {
    auto run = FreeRunOver(stretch.segment, model, stretch.position, needed);
    if (!run) return std::nullopt;
    const auto add_to = [&](FigureSums* sums) {
      sums->Add(run->time, run->measured, run->predicted);
    };
    if (stretch.part != LogPart::kOutside) add_to(&all);
    if (stretch.part == LogPart::kTrain) add_to(&train);
    if (stretch.part == LogPart::kHeldOut) add_to(&held_out);
    prediction.segments.push_back(std::move(stretch.segment));
    prediction.parts.push_back(stretch.part);
    prediction.velocity.push_back(std::move(run->predicted));
  }
  prediction.figures = all.Figures();
  prediction.train = train.Figures();
  prediction.held_out = held_out.Figures();
  return prediction;
}

}  // namespace fathom
