// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/started_model.h"

#include "fathom/diagnosis/fit/normal_equations.h"
#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/diagnosis/fit/unknowns.h"

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr int kNumSteps = 3;

}  // namespace

StartedModel StartedFrom(const StructureFit& fit) {
  return {fit.model, fit.covariance, fit.initial, fit.residual};
}

std::optional<StartedModel> UsersModel(const TrainingData& data, const RobustStart& start) {
  StartedModel users = {start.model, start.covariance, start.initial, {}};
  auto at = data.Linearise(users.model, users.initial);
  if (!at) return std::nullopt;
  users.residual = data.measured() - at->simulated;
  const Eigen::Index num_parameters = EffectSimulation::NumParameters(users.model);
  for (int step = 0; step < kNumSteps; ++step) {
    const Whitener white(WhiteNoise(data, users.residual), data.samples());
    const Normal normal = NormalOf(
        white, at->jacobian.rightCols(at->jacobian.cols() - num_parameters), users.residual);
    Unknowns unknowns = Pack(data, users.model, users.initial);
    unknowns.value.tail(normal.g.size()) += normal.A.ldlt().solve(normal.g);
    Unpack(data, unknowns.value, &users.model, &users.initial);
    at = data.Linearise(users.model, users.initial);
    if (!at) return std::nullopt;
    users.residual = data.measured() - at->simulated;
  }
  return users;
}

}  // namespace fathom
