// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/log_prediction.h"

#include "fathom/base/input_error.h"
#include "fathom/signal/signals.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/signal/split_at_gaps.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/prediction.h"
#include "fathom/simulate/run_start.h"

#include <cmath>
#include <cstddef>
#include <limits>
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

std::vector<Segment> SegmentsOf(const Stream& velocity, Dof dof, const HeldCommand& command) {
  const std::vector<double>& measured = *velocity.Find(VelocityColumn(dof));
  std::vector<Segment> segments;
  for (const SampleRange& range : SplitAtGaps(velocity.time)) {
    const auto part = [&](const std::vector<double>& all) {
      return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(range.begin),
                                 all.begin() + static_cast<std::ptrdiff_t>(range.end));
    };
    Segment& segment = segments.emplace_back();
    segment.time = part(velocity.time);
    segment.velocity = part(measured);
    segment.command = command;
  }
  return segments;
}

std::vector<Segment> SegmentsOf(const Log& log, Dof dof) {
  const HeldCommand command = CommandOf(log, dof);
  if (log.velocity && log.velocity->Find(VelocityColumn(dof)) != nullptr) {
    return SegmentsOf(*log.velocity, dof, command);
  }
  if (log.pose) {
    return SignalsOf(log, dof, {.source = Source::kCamera, .split_held_out = false}).train;
  }
  Segment segment;
  segment.time = command.time;
  segment.command = command;
  segment.velocity.assign(segment.time.size(), std::numeric_limits<double>::quiet_NaN());
  segment.velocity.front() = 0.0;
  return {segment};
}

}  // namespace

std::optional<LogPrediction> PredictLog(const FittedModel& fitted, const Log& log) {
  RequireUnitOf(fitted, log);
  const ExtendedModel model = fitted.Extended();
  LogPrediction prediction;
  prediction.segments = SegmentsOf(log, fitted.dof);
  const bool is_measured = std::isfinite(prediction.segments.front().velocity.back());
  EffectInputs inputs;
  if (!model.effects.empty()) {
    inputs = EffectInputsOf(log, fitted.dof);
    RequirePartners(model, inputs, log);
  }
  FigureSums sums;
  for (const Segment& segment : prediction.segments) {
    const double first = segment.velocity.front();
    const double position = PositionAt(log, fitted.dof, segment.time.front());
    const auto start = is_measured ? StartOf(model, segment, first, position, &inputs)
                                   : InitialState{first, position};
    if (!start) return std::nullopt;
    auto velocity = Predict(model, segment, *start, &inputs);
    if (!velocity) return std::nullopt;
    sums.Add(segment.time, segment.velocity, *velocity);
    prediction.velocity.push_back(std::move(*velocity));
  }
  prediction.figures = sums.Figures();
  return prediction;
}

}  // namespace fathom
