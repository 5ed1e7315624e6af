// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace fathom {

// Diagnoses that no search has touched: all numbers chosen by hand, all different.

inline Eigen::MatrixXd Diagonal(const std::vector<double>& stds) {
  Eigen::VectorXd variances(static_cast<Eigen::Index>(stds.size()));
  for (Eigen::Index i = 0; i < variances.size(); ++i) {
    variances[i] = stds[static_cast<std::size_t>(i)] * stds[static_cast<std::size_t>(i)];
  }
  return variances.asDiagonal();
}

// The free run of 6 s at 1 Hz in the middle of which a model is 0.02 m/s off, measured without
// noise.
inline ResidualTrace HandmadeTrace(double start, bool is_held_out) {
  ResidualTrace trace;
  trace.log = "tank_07";
  trace.is_held_out = is_held_out;
  trace.measured = {0.0, 0.1, 0.3, 0.4, 0.3, 0.1};
  for (int i = 0; i < 6; ++i) trace.time.push_back(start + i);
  trace.before = {0.0, 0.1, 0.32, 0.42, 0.3, 0.1};
  trace.after = trace.measured;
  return trace;
}

// A surge log on which nothing is missing: inertia 1086 +- 13 kg and so on.
inline Diagnosis ConsistentDiagnosis() {
  Diagnosis diagnosis;
  diagnosis.dof = Dof::kSurge;
  diagnosis.force_unit = "N";
  diagnosis.logs = {"tank_07"};
  diagnosis.verdict = Verdict::kConsistent;
  diagnosis.baseline.model.baseline = {
      .inertia = 1086.0, .quadratic_damping = 55.0, .linear_damping = 49.9, .buoyancy = -0.88};
  diagnosis.baseline.covariance = Diagonal({13.0, 4.0, 8.1, 0.23});
  diagnosis.baseline.train = {.mae = 0.0115, .nmae = 0.1147, .num_samples = 2400, .duration = 240};
  diagnosis.baseline.held_out = {.mae = 0.0117, .nmae = 0.1169, .num_samples = 600, .duration = 60};
  diagnosis.baseline.weighed_log_likelihood = 1234.5;
  diagnosis.extended = diagnosis.baseline;
  diagnosis.remaining_p_value = 0.6;
  diagnosis.traces = {HandmadeTrace(10.0, false), HandmadeTrace(20.0, true)};
  diagnosis.missing_force.time = {10.0, 11.0, 12.0, 13.0, 14.0};
  diagnosis.missing_force.mean = {1.0, -2.0, 3.0, -4.0, 5.0};
  diagnosis.missing_force.std = {0.5, 0.5, 0.5, 0.5, 0.5};
  diagnosis.missing_force.command = {-20.0, 20.0, -30.0, 40.0, -50.0};
  return diagnosis;
}

// One that sees structure that nothing in the catalogue has.
inline Diagnosis UnexplainedDiagnosis() {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.verdict = Verdict::kUnexplained;
  diagnosis.remaining_p_value = 1e-9;
  return diagnosis;
}

// Adds a cause whose values have these standard deviations, independent of all others.
inline void AddCause(const std::string& effect,
                     const std::vector<double>& values,
                     const std::vector<double>& stds,
                     Diagnosis* diagnosis) {
  auto& extended = diagnosis->extended;
  extended.model.effects.push_back({FindEffect(effect), {}, values});
  const Eigen::Index size = extended.covariance.rows();
  const auto added = static_cast<Eigen::Index>(stds.size());
  extended.covariance.conservativeResizeLike(Eigen::MatrixXd::Zero(size + added, size + added));
  extended.covariance.bottomRightCorner(added, added) = Diagonal(stds);
  Cause cause;
  cause.effect_index = static_cast<int>(extended.model.effects.size()) - 1;
  cause.p_value = 1e-20;
  cause.delta_bic = 277.0;
  cause.held_out_gain = 0.316;
  diagnosis->causes.push_back(cause);
}

// A dead zone that explains 70 % of the squared error beyond scatter, and moves the inertia to
// 852.5 +- 5.9 kg.
inline Diagnosis ExplainedDiagnosis() {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.verdict = Verdict::kExplained;
  diagnosis.extended.model.baseline = {
      .inertia = 852.5, .quadratic_damping = 54.0, .linear_damping = 49.8, .buoyancy = -0.81};
  diagnosis.extended.covariance = Diagonal({5.9, 3.0, 0.83, 0.010});
  diagnosis.extended.train.nmae = 0.0808;
  diagnosis.extended.held_out.nmae = 0.0800;
  AddCause("thrust_dead_zone", {7.9998}, {0.17}, &diagnosis);
  diagnosis.explained_share = 0.7;
  diagnosis.held_out_gain = 0.3157;
  diagnosis.held_out_gain_low = 0.23;
  diagnosis.held_out_gain_high = 0.371;
  diagnosis.missing_force.explained = {1.1, -2.1, 3.1, -4.1, 5.1};
  Candidate kept;
  kept.effect = FindEffect("thrust_dead_zone");
  kept.label = "thrust_dead_zone";
  kept.values = {7.9998};
  kept.stds = {0.17};
  kept.score = 117.4;
  kept.gain = 283.8;
  kept.delta_bic = 277.0;
  kept.p_value = 1e-20;
  kept.noise_reach = 11.2;
  kept.outcome = CandidateOutcome::kKept;
  Candidate dropped;
  dropped.effect = FindEffect("thrust_fade");
  dropped.label = "thrust_fade";
  dropped.gain = std::numeric_limits<double>::quiet_NaN();
  dropped.delta_bic = std::numeric_limits<double>::quiet_NaN();
  dropped.score = 0.25;
  dropped.p_value = 0.36;
  dropped.noise_reach = 11.2;
  dropped.outcome = CandidateOutcome::kScoreWithinNoise;
  diagnosis.candidates = {kept, dropped};
  return diagnosis;
}

inline std::vector<Alternative> AlternativesNamed(std::initializer_list<const char*> effects) {
  std::vector<Alternative> alternatives;
  for (const char* effect : effects) alternatives.push_back({FindEffect(effect), {}, effect});
  return alternatives;
}

// A lag of 0.4963 s in the thrusters or in the sensor.
inline Diagnosis AmbiguousDiagnosis() {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.verdict = Verdict::kAmbiguous;
  diagnosis.causes.clear();
  diagnosis.extended.model.effects.clear();
  diagnosis.extended.covariance = Diagonal({5.9, 3.0, 0.83, 0.010});
  AddCause("sensor_lag", {0.4963}, {0.0077}, &diagnosis);
  diagnosis.causes[0].alternatives = AlternativesNamed({"thruster_lag"});
  diagnosis.causes[0].experiment.text =
      "Large steps, to speeds where quadratic drag matters: in linear drag lags commute.";
  return diagnosis;
}

}  // namespace fathom
