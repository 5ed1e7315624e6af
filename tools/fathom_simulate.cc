// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a model predicts for a log: a free run over its command, scored against its measurement.

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/signal/log_column.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/prediction.h"
#include "fathom/simulate/run_start.h"
#include "fathom/tool/log_flags.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/tool.h"
#include "fathom/vehicle/model_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(model, "", "Model or verdict file (JSON).");
DEFINE_string(out, "", "Write t and the predicted velocity to this CSV file.");
DEFINE_bool(
    keep_run_effects,
    false,
    "Keep effects that belong to one run (a current, a bias, a lost thruster) on other logs "
    "than that run's, too; their times then count from this log's first command.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_simulate",
    "Predicts a log's velocity from its command by a free-running simulation, and scores it.",
    "--model=FILE --log=LOG [--velocity=FILE] [--out=FILE] [--keep_run_effects]",
    "fathom_simulate --model=surge.json --log=data/flatfish --out=prediction.csv",
    "The prediction stands at the stamps of the log's motion stream (its command stream where "
    "there is none) and starts from the first measured speed (where a sensor lags, from what shows "
    "the first two seconds best); a silence of over 30 s starts it anew. A verdict of "
    "fathom_diagnose is simulated with its causes, as the sensor would show it; what other DOFs "
    "take part is taken from the log. Causes that belong to one run are left out on any other "
    "log."};

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

// Leaves out of the model what belongs to another run than the log's, and says what that was.
std::vector<std::string> LeaveOutRunEffects(const Log& log, FittedModel* fitted) {
  const auto& known = fitted->log_fingerprints;
  const auto own = std::find(known.begin(), known.end(), FingerprintOf(log)) - known.begin();
  const bool is_known = own < std::ssize(known);
  const std::string name = is_known && own < std::ssize(fitted->logs) ? fitted->logs[own] : "";
  std::vector<std::string> left_out;
  std::erase_if(fitted->effects, [&](const ActiveEffect& active) {
    const EffectInfo& info = active.effect->info();
    if (info.scope != Scope::kRun || FLAGS_keep_run_effects) return false;
    if (is_known && active.setting.ActsIn(name)) return false;
    left_out.push_back(LabelOf(info, active.setting));
    return true;
  });
  for (ActiveEffect& active : fitted->effects) active.setting.log.clear();  // this is the log
  return left_out;
}

// Free runs of a model over the segments of a log, with effects or without.
class FreeRuns {
 public:
  FreeRuns(const FittedModel& fitted, const Log& log)
      : model_(fitted.Extended()),
        segments_(SegmentsOf(log, fitted.dof)),
        positions_(segments_.size(), 0.0) {
    if (model_.effects.empty()) return;
    inputs_ = EffectInputsOf(log, fitted.dof);
    RequirePartners(model_, inputs_, log);
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      positions_[k] = PositionAt(log, fitted.dof, segments_[k].time.front());
    }
    is_measured_ = std::isfinite(segments_.front().velocity.back());
  }

  const std::vector<Segment>& segments() const { return segments_; }

  // Started from the first measured speed, or readings; nothing if it diverges.
  std::optional<std::vector<double>> Predict(size_t k) const {
    const Segment& segment = segments_[k];
    const double first = segment.velocity.front();
    const auto start = is_measured_ ? StartOf(model_, segment, first, positions_[k], &inputs_)
                                    : InitialState{first, positions_[k]};
    if (!start) return std::nullopt;
    return fathom::Predict(model_, segment, *start, &inputs_);
  }

  FitFigures Figures() const { return FiguresOf(model_, segments_, positions_, &inputs_); }

 private:
  const ExtendedModel model_;
  const std::vector<Segment> segments_;
  EffectInputs inputs_;
  std::vector<double> positions_;
  bool is_measured_ = false;
};

int Run() {
  RequireFlag("model", FLAGS_model, "a model or verdict file");
  RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
  RequireOutputs({{"out", FLAGS_out}}, {FLAGS_model, FLAGS_log, FLAGS_velocity});
  FittedModel fitted = ReadModel(FLAGS_model);
  const Log log = ReadLogFromFlags(FLAGS_log, fitted.dof, /*may_lack_motion=*/true);
  const std::string log_unit =
      log.command_unit.empty() ? std::string(ForceUnit(fitted.dof)) : log.command_unit;
  if (log_unit != fitted.force_unit) {
    throw InputError(
        fmt::format("{}: its commands are in {}, but the model was identified from commands in {}: "
                    "expected the same unit.",
                    FLAGS_log,
                    log_unit,
                    fitted.force_unit));
  }
  const std::vector<std::string> left_out = LeaveOutRunEffects(log, &fitted);
  const FreeRuns runs(fitted, log);
  std::string csv = fmt::format("t,{}\n", VelocityColumn(fitted.dof));
  for (size_t k = 0; k < runs.segments().size(); ++k) {
    const auto predicted = runs.Predict(k);
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
      csv += fmt::format("{},{}\n", runs.segments()[k].time[i], (*predicted)[i]);
    }
  }
  const FitFigures figures = runs.Figures();
  if (std::isfinite(figures.mae)) {
    std::printf("%s: MAE %.5f %s, NMAE %s over %d samples, %.0f s\n",
                std::string(Name(fitted.dof)).c_str(),
                figures.mae,
                std::string(VelocityUnit(fitted.dof)).c_str(),
                std::isfinite(figures.nmae) ? fmt::format("{:.4f}", figures.nmae).c_str() : "-",
                figures.num_samples,
                figures.duration);
  } else {
    std::printf(
        "%s: predicted from rest; the log has no column '%s' and no pose to score it by%s\n",
        std::string(Name(fitted.dof)).c_str(),
        std::string(VelocityColumn(fitted.dof)).c_str(),
        log.detections ? ". fathom_track makes poses from its detections.csv." : "");
  }
  if (const auto remark =
          RemarkOnEarlyEnd(CommandOf(log, fitted.dof), runs.segments().back().time, kLongestGap);
      !remark.empty()) {
    std::printf("note: %s\n", remark.c_str());
  }
  if (!left_out.empty()) {
    std::printf(
        "note: left out: %s. What belongs to the run that the model was identified from need not "
        "hold in another one; --keep_run_effects keeps it.\n",
        fmt::format("{}", fmt::join(left_out, ", ")).c_str());
  }
  if (!FLAGS_out.empty()) WriteFile(FLAGS_out, csv);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
