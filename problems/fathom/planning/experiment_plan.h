// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/ordinary_sine.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/planning/wrench_block.h"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Where no command is found.
inline constexpr std::string_view kNoCommandKeepsLimits =
    "No command was found that keeps the limits for nearly all models that the log allows. Give it "
    "more room, less time, or a model of narrower intervals.";

// What an experiment says of one parameter: standard deviations of its estimate.
struct PlannedParameter {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  std::string name;  // as in files: "inertia", "thruster_lag.time_constant"
  std::string unit;
  double value = kNotComputed;
  double before = kNotComputed;           // by the log so far, and the flown ones
  double after = kNotComputed;            // by the planned experiment and flown logs
  double with_log_so_far = kNotComputed;  // by all
  double sine = kNotComputed;             // by the ordinary sine and flown logs
};

// How well two explanations are told apart, in standard deviations: 1 true, the other assumed.
struct PlannedSeparation {
  std::string truth, assumed;
  double sigmas = 0.0;  // under the plan
  double sine = 0.0;    // under the ordinary sine

  // Under the plan where positions are measured along, AdvisedPositionNoise() at each velocity.
  // NaN: not asked, since they are measured anyhow or the pair is told apart.
  double with_positions = std::numeric_limits<double>::quiet_NaN();

  bool IsDecided() const { return sigmas >= kDecided; }
  bool PositionsDecide() const { return with_positions >= kDecided; }

  static constexpr double kDecided = 4.95;  // 5.0 as printed
};

// A quantity over the run with the range that holds 95 % of the models.
struct PlannedBand {
  std::vector<double> value, low, high;
};

// What a camera and markers reach without pains, or a tape measure beside a film: 2 cm, 10 mrad.
inline double AdvisedPositionNoise(Dof dof) { return IsAngular(dof) ? 0.01 : 0.02; }

// The next experiment: docs/plan.md.
struct ExperimentPlan {
  // False: no command was found that keeps the limits; nothing below is filled in.
  bool IsUsable() const { return message.empty(); }
  std::string message = "PlanExperiment() was not called.";

  std::vector<WrenchBlock> blocks;
  HeldCommand command;    // from t = 0 on
  double force = 0.0;     // greatest that was tried: UsableForce() [N] or [N m]
  double duration = 0.0;  // [s], of whole cells
  VelocityMeasurement measurement;
  double share_breaking = 0.0;  // of the models that the log allows, those that break a limit
  int num_models = 0;           // that this was counted in
  std::vector<PlannedParameter> parameters;
  std::vector<PlannedSeparation> separations;
  std::string led_by;  // the rival that parameters and limits are planned for; empty without rivals
  std::vector<std::string> breaking_rivals;  // under which the vehicle passes a limit: their labels

  OrdinarySine sine;  // the greatest that the limits leave

  std::vector<double> time;  // of the command and the coast behind it, kCoastAfterwards [s]
  PlannedBand speed;         // [m/s] or [rad/s]
  PlannedBand displacement;  // from the start [m] or [rad]
  ValueRange speed_range;    // that 95 % of the models stay in
  ValueRange distance_range;
};

}  // namespace fathom
