// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a model predicts for a log: a free run over its command, scored against its measurement.

#include "fathom/base/files/output_file.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/signal/split_at_gaps.h"
#include "fathom/simulate/log_prediction.h"
#include "fathom/simulate/model_for_log.h"
#include "fathom/tool/log_flags.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/tool.h"
#include "fathom/vehicle/files/model_file.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>
#include <nlohmann/json.hpp>

DEFINE_string(model, "", "Model or verdict file (JSON).");
DEFINE_string(out, "", "Write t and the predicted velocity to this CSV file.");
DEFINE_string(json, "", "Write the score to this JSON file.");
DEFINE_bool(
    keep_run_effects,
    false,
    "Keep effects of a run (a current, a bias, a lost thruster) also on other logs. Their times "
    "then count from this log's first command.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_simulate",
    "Predicts a log's velocity by simulating from its command alone, and scores the prediction.",
    "--model=FILE --log=LOG [--velocity=FILE] [--out=FILE] [--json=FILE] [--keep_run_effects]",
    "fathom_simulate --model=surge.json --log=data/flatfish --out=prediction.csv",
    "The prediction is at the stamps of the log's motion stream, or of its command if there is "
    "none. It starts from the first measured speed (with a sensor lag, from the state that fits "
    "the first two seconds best) and starts anew after a gap of over 30 s. A verdict of "
    "fathom_diagnose is simulated with its causes, as the sensor would show it. The motion of "
    "other DOFs is taken from the log. Causes of a run are left out on any other log."};

// t and the predicted velocity at the stamps of all segments.
std::string FormatPrediction(const LogPrediction& prediction, Dof dof) {
  std::string csv = fmt::format("t,{}\n", VelocityColumn(dof));
  for (size_t k = 0; k < prediction.segments.size(); ++k) {
    const std::vector<double>& time = prediction.segments[k].time;
    for (size_t i = 0; i < time.size(); ++i) {
      csv += fmt::format("{},{}\n", time[i], prediction.velocity[k][i]);
    }
  }
  return csv;
}

void PrintFigures(const FitFigures& figures, const Log& log, Dof dof) {
  if (!std::isfinite(figures.mae)) {
    std::printf(
        "%s: predicted from rest. The log has no column '%s' and no pose to score the "
        "prediction%s\n",
        std::string(Name(dof)).c_str(),
        std::string(VelocityColumn(dof)).c_str(),
        log.detections ? ". fathom_track makes poses from its detections.csv." : "");
    return;
  }
  std::printf("%s: velocity MAE %.5f %s, velocity NMAE %s over %d samples, %.0f s\n",
              std::string(Name(dof)).c_str(),
              figures.mae,
              std::string(VelocityUnit(dof)).c_str(),
              std::isfinite(figures.nmae) ? fmt::format("{:.4f}", figures.nmae).c_str() : "-",
              figures.num_samples,
              figures.duration);
}

// Schema "fathom-score-1"; docs/file_formats.md. A number that is not known is null.
std::string FormatScore(const FitFigures& figures, const Log& log, Dof dof) {
  using Json = nlohmann::ordered_json;
  const Json json = {{"schema", "fathom-score-1"},
                     {"log", log.name},
                     {"dof", Name(dof)},
                     {"mae", figures.mae},
                     {"nmae", figures.nmae},
                     {"n", figures.num_samples},
                     {"duration", figures.duration}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int Run() {
  RequireFlag("model", FLAGS_model, "a model or verdict file");
  RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
  RequireOutputs({{"out", FLAGS_out}, {"json", FLAGS_json}},
                 {FLAGS_model, FLAGS_log, FLAGS_velocity});
  const FittedModel fitted = ReadModel(FLAGS_model);
  const Log log = ReadLogFromFlags(FLAGS_log, fitted.dof, /*may_lack_motion=*/true);
  const auto [model, left_out] = RestrictToLog(fitted, log, FLAGS_keep_run_effects);
  const auto prediction = PredictLog(model, log);
  if (!prediction) {
    std::fprintf(stderr,
                 "fathom_simulate: the simulation of %s diverges or is too stiff: inertia %g, "
                 "linear damping %g.\n",
                 FLAGS_model.c_str(),
                 model.model.inertia,
                 model.model.linear_damping);
    return 2;
  }
  PrintFigures(prediction->figures, log, model.dof);
  const std::string remark =
      RemarkOnEarlyEnd(CommandOf(log, model.dof), prediction->segments.back().time, kLongestGap);
  if (!remark.empty()) std::printf("note: %s\n", remark.c_str());
  if (!left_out.empty()) {
    std::printf(
        "note: left out: %s. Effects of the run that the model was identified from need not hold "
        "in another one. --keep_run_effects keeps them.\n",
        fmt::format("{}", fmt::join(left_out, ", ")).c_str());
  }
  if (!FLAGS_json.empty()) {
    WriteFile(FLAGS_json, FormatScore(prediction->figures, log, model.dof));
  }
  if (!FLAGS_out.empty()) WriteFile(FLAGS_out, FormatPrediction(*prediction, model.dof));
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
