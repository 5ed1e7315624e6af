// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// How far a free-running simulation is from the measured velocity. NaN: not computed.
struct FitFigures {
  double mae = std::numeric_limits<double>::quiet_NaN();   // [m/s] or [rad/s], docs/models.md (7)
  double nmae = std::numeric_limits<double>::quiet_NaN();  // no unit, docs/models.md (8)
  int num_samples = 0;
  double duration = 0.0;  // [s], summed over the segments
};

// A model whose free runs miss more of the motion than this is a poor one.
inline constexpr double kPoorFit = 0.3;

// The smallest and the greatest of some values.
struct ValueRange {
  double low = 0.0;
  double high = 0.0;
};

// What data reach: a model of them extrapolates beyond.
struct DataRange {
  ValueRange speed;  // [m/s] or [rad/s]
  ValueRange force;  // commanded [N] or [N m]
};

// A model with what is known about its making: what a model file holds.
struct FittedModel {
  Dof dof = Dof::kSurge;
  std::string force_unit;  // "N", "N m", or the log's command_unit
  UncoupledModel<double> model;
  std::vector<ActiveEffect> effects;  // on top of it, as in ExtendedModel; mostly none

  // Of the model's parameters in the order of kParameterInfo, then the effects' in theirs; in
  // products of the parameters' units. NaN where not known.
  Eigen::MatrixXd covariance =
      ParameterCovariance::Constant(std::numeric_limits<double>::quiet_NaN());

  FitFigures train;
  FitFigures held_out;
  // Colour of the velocities that the fit's free runs miss: phi_1 ... of docs/output_error.md (5),
  // over samples of the rate of `train`. No numbers: white. Nothing: not known.
  std::optional<std::vector<double>> residual_autoregression;
  std::optional<DataRange> range;  // of the training data; files of before have none
  // How much of the commanded force each thruster had to give, by name: ThrusterSharesOf(). Empty:
  // not known.
  std::map<std::string, double> thruster_shares;

  std::vector<std::string> caveats;               // what the intervals do not cover
  std::map<std::string, std::string> provenance;  // log, family, source, options, version

  // FingerprintOf() the logs that it was identified from: in these alone hold those of its effects
  // that belong to a run.
  std::vector<std::string> log_fingerprints;

  // Their names, in the same order, where EffectSetting::log goes by them; otherwise empty.
  std::vector<std::string> logs;

  ExtendedModel Extended() const { return {model, effects}; }
};

}  // namespace fathom
