// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a model predicts for a log: a free run over its command, scored against its measurement.

#include "fathom/base/input_error.h"
#include "fathom/base/output_file.h"
#include "fathom/comparison/comparison.h"
#include "fathom/signal/log_column.h"
#include "fathom/simulate/prediction.h"
#include "fathom/tools/identifier_flags.h"
#include "fathom/tools/tool.h"
#include "fathom/vehicle/model_file.h"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(model, "", "Model or verdict file (JSON).");
DEFINE_string(out, "", "Write t and the predicted velocity to this CSV file.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_simulate",
    "Predicts a log's velocity from its command by a free-running simulation, and scores it.",
    "--model=FILE --log=LOG [--velocity=FILE] [--out=FILE]",
    "fathom_simulate --model=surge.json --log=data/flatfish --out=prediction.csv",
    "The prediction stands at the stamps of the log's motion stream (its command stream where "
    "there "
    "is none) and starts from the first measured speed; a silence of over 30 s starts it anew."};

constexpr double kLongestGap = 30.0;  // [s], as in SignalsOptions

// The whole log as segments, held-out intervals and all; without a motion stream one segment at the
// command's stamps whose "measured" velocity is NaN but for the start from rest.
std::vector<Segment> SegmentsOf(const Log& log, Dof dof) {
  const HeldCommand command = CommandOf(log, dof);
  if (log.velocity) {
    if (const auto* measured = log.velocity->Find(VelocityColumn(dof))) {
      return SegmentsAtEveryStamp(log.velocity->time, *measured, command, kLongestGap);
    }
  }
  if (log.pose) {
    auto segments = SignalsOf(log, dof, {.source = Source::kCamera, .split_held_out = false}).train;
    for (Segment& segment : segments) segment.initial_velocity = segment.velocity.front();
    return segments;
  }
  Segment segment;
  segment.time = command.time;
  segment.command = command;
  segment.velocity.assign(segment.time.size(), std::nan(""));
  segment.velocity.front() = 0.0;
  return {segment};
}

int Run() {
  RequireFlag("model", FLAGS_model, "a model or verdict file");
  RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
  const FittedModel fitted = ReadModel(FLAGS_model);
  const Log log = ReadLogFromFlags(FLAGS_log, fitted.dof, /*may_lack_motion=*/true);
  const std::string log_unit =
      log.command_unit.empty() ? std::string(ForceUnit(fitted.dof)) : log.command_unit;
  if (log_unit != fitted.force_unit) {
    throw InputError(
        fmt::format("{}: its commands are in {}, but the model was identified from commands in {}: "
                    "expected the "
                    "same unit.",
                    FLAGS_log,
                    log_unit,
                    fitted.force_unit));
  }
  const std::vector<Segment> segments = SegmentsOf(log, fitted.dof);
  std::string csv = fmt::format("t,{}\n", VelocityColumn(fitted.dof));
  for (const Segment& segment : segments) {
    const auto predicted = PredictVelocity(fitted.model, segment, segment.velocity.front());
    if (!predicted) {
      std::fprintf(stderr,
                   "fathom_simulate: the simulation of %s diverges or is too stiff: inertia %g, "
                   "linear damping %g.\n",
                   FLAGS_model.c_str(),
                   fitted.model.inertia,
                   fitted.model.linear_damping);
      return 2;
    }
    for (size_t i = 0; i < predicted->size(); ++i) {
      csv += fmt::format("{},{}\n", segment.time[i], (*predicted)[i]);
    }
  }
  const FitFigures figures = FiguresOf(fitted.model, segments);
  if (std::isfinite(figures.mae)) {
    std::printf("%s: MAE %.5f %s, NMAE %s over %d samples, %.0f s\n",
                std::string(Name(fitted.dof)).c_str(),
                figures.mae,
                std::string(VelocityUnit(fitted.dof)).c_str(),
                std::isfinite(figures.nmae) ? fmt::format("{:.4f}", figures.nmae).c_str() : "-",
                figures.num_samples,
                figures.duration);
  } else {
    std::printf("%s: predicted from rest; the log has no column '%s' and no pose to score it by\n",
                std::string(Name(fitted.dof)).c_str(),
                std::string(VelocityColumn(fitted.dof)).c_str());
  }
  if (!FLAGS_out.empty()) WriteFile(FLAGS_out, csv);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
