// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/prediction_remarks.h"

#include "fathom/base/dof.h"
#include "fathom/simulate/data_range.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

// As measured; where nothing was, as predicted.
std::optional<DataRange> RangeOfLog(const LogPrediction& prediction) {
  if (std::isfinite(prediction.figures.mae)) return RangeOf(prediction.segments);
  std::vector<Segment> segments = prediction.segments;
  for (std::size_t k = 0; k < segments.size(); ++k) segments[k].velocity = prediction.velocity[k];
  return RangeOf(segments);
}

bool Leaves(const ValueRange& log, const ValueRange& fitted) {
  constexpr double kMargin = 0.1;
  const double margin = kMargin * (fitted.high - fitted.low);
  return log.low < fitted.low - margin || log.high > fitted.high + margin;
}

void AddIfItLeaves(std::string_view what,
                   std::string_view unit,
                   const ValueRange& log,
                   const ValueRange& fitted,
                   std::vector<std::string>* remarks) {
  if (!Leaves(log, fitted)) return;
  remarks->push_back(
      fmt::format("The {} of this log, {:.3g} to {:.3g} {}, leaves what the model was fitted to, "
                  "{:.3g} to {:.3g} {}. Beyond it the model extrapolates.",
                  what,
                  log.low,
                  log.high,
                  unit,
                  fitted.low,
                  fitted.high,
                  unit));
}

}  // namespace

std::vector<std::string> RemarksOn(const FittedModel& model, const LogPrediction& prediction) {
  std::vector<std::string> remarks;
  if (model.caveats.empty() && model.train.nmae > kPoorFit) {
    remarks.push_back(
        fmt::format("The model is a poor fit: its NMAE on the data that it was fitted to is "
                    "{:.2f}, above {}.",
                    model.train.nmae,
                    kPoorFit));
  }
  if (prediction.figures.nmae > kPoorFit) {
    remarks.push_back(
        fmt::format("The prediction of this log is poor: its NMAE is {:.2f}, above {}.",
                    prediction.figures.nmae,
                    kPoorFit));
  }
  const auto log = RangeOfLog(prediction);
  if (!model.range || !log) return remarks;
  AddIfItLeaves("speed", VelocityUnit(model.dof), log->speed, model.range->speed, &remarks);
  AddIfItLeaves("force", model.force_unit, log->force, model.range->force, &remarks);
  return remarks;
}

}  // namespace fathom
