// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "known_noise_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

namespace fathom::hidden {
namespace {

constexpr double kConverged = 1e-3;  // of chi2
constexpr int kFirstEffect = EffectSimulation::kFirstEffectColumn;

// All parameters in the order of the sensitivities' columns.
Eigen::VectorXd Pack(const ExtendedModel& model, const InitialState& initial) {
  std::vector<double> p = {model.baseline.inertia,
                           model.baseline.quadratic_damping,
                           model.baseline.linear_damping,
                           model.baseline.buoyancy,
                           initial.velocity,
                           initial.position};
  for (const ActiveEffect& effect : model.effects) {
    p.insert(p.end(), effect.values.begin(), effect.values.end());
  }
  return Eigen::Map<Eigen::VectorXd>(p.data(), static_cast<Eigen::Index>(p.size()));
}

void Unpack(const Eigen::VectorXd& p, ExtendedModel* model, InitialState* initial) {
  model->baseline = {p[0], p[1], p[2], p[3]};
  *initial = {p[4], p[5]};
  Eigen::Index column = kFirstEffect;
  for (ActiveEffect& effect : model->effects) {
    for (double& value : effect.values) value = p[column++];
  }
}

// Within the bounds of physical values; inertia and effects with open ends stay within a factor of
// 20 of where they were, so that no step leaves the world.
Eigen::VectorXd Clamped(Eigen::VectorXd p,
                        const Eigen::VectorXd& before,
                        const ExtendedModel& model) {
  p[0] = std::clamp(p[0], 0.2 * before[0], 5.0 * before[0]);
  p[1] = std::max(p[1], 0.0);
  p[2] = std::max(p[2], 0.0);
  Eigen::Index column = kFirstEffect;
  for (const ActiveEffect& effect : model.effects) {
    for (const EffectParameter& parameter : effect.effect->info().parameters) {
      double lower = parameter.lower, upper = parameter.upper;
      if (std::isinf(parameter.null)) {  // a limit: never below a twentieth of what it was
        lower = std::max(lower, 0.3 * before[column]);
        upper = std::min(upper, 3.0 * before[column]);
      }
      p[column] = std::clamp(p[column], lower, upper);
      ++column;
    }
  }
  return p;
}

}  // namespace

KnownNoiseFit FitWithKnownNoise(const KnownRun& run,
                                const ExtendedModel& start,
                                const InitialState& initial,
                                const KnownNoiseFitOptions& options) {
  KnownNoiseFit fit;
  fit.model = start;
  fit.initial = initial;
  Eigen::VectorXd p = Pack(start, initial);
  fit.num_effect_parameters = static_cast<int>(p.size()) - kFirstEffect;
  Eigen::VectorXd residual;
  RowMajorMatrix sensitivity;
  if (!run.Linearise(fit.model, fit.initial, &residual, &sensitivity)) return fit;
  fit.chi2 = residual.squaredNorm();
  double damping = 1e-3;
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    Eigen::MatrixXd information = sensitivity.transpose() * sensitivity;
    Eigen::VectorXd gradient = sensitivity.transpose() * residual;
    const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().unaryExpr(
        [](double x) { return x > 0.0 ? 1.0 / x : 0.0; });
    // Scaled to a diagonal of 1. What has no influence, or is not to be fitted, stays.
    information = scale.asDiagonal() * information * scale.asDiagonal();
    gradient = scale.cwiseProduct(gradient);
    for (Eigen::Index j = 0; j < p.size(); ++j) {
      const bool is_start = j == EffectSimulation::kInitialVelocityColumn ||
                            j == EffectSimulation::kInitialPositionColumn;
      const bool is_unseen_position = j == EffectSimulation::kInitialPositionColumn &&
                                      !run.has_displacement() && !options.start_only;
      const bool is_held =
          scale[j] == 0.0 || is_unseen_position || (options.start_only && !is_start);
      if (!is_held) continue;
      information.row(j).setZero();
      information.col(j).setZero();
      information(j, j) = 1.0;
      gradient[j] = 0.0;
    }
    information.diagonal().array() += 1e-10;
    // The best that the linear forecast promises.
    const double promised = gradient.dot(information.ldlt().solve(gradient));
    if (promised < kConverged) {
      fit.converged = true;
      break;
    }
    if (iteration >= 3 && fit.chi2 - 3.0 * promised > options.wanted_chi2) break;
    bool has_moved = false;
    for (int attempt = 0; attempt < 8 && !has_moved; ++attempt) {
      Eigen::MatrixXd damped = information;
      damped.diagonal() *= 1.0 + damping;
      const Eigen::VectorXd step = scale.cwiseProduct(damped.ldlt().solve(gradient));
      const Eigen::VectorXd next = Clamped(p + step, p, fit.model);
      ExtendedModel model = fit.model;
      InitialState state = fit.initial;
      Unpack(next, &model, &state);
      Eigen::VectorXd tried;
      if (run.Residual(model, state, &tried) && tried.squaredNorm() < fit.chi2) {
        const double gained = fit.chi2 - tried.squaredNorm();
        p = next;
        fit.model = model;
        fit.initial = state;
        fit.chi2 = tried.squaredNorm();
        damping = std::max(1e-7, 0.2 * damping);
        has_moved = true;
        fit.converged = gained < kConverged;
      } else {
        damping *= 8.0;
      }
    }
    if (!has_moved) fit.converged = true;  // at a kink: no step goes down
    if (fit.converged) break;
    if (!run.Linearise(fit.model, fit.initial, &residual, &sensitivity)) break;
  }
  return fit;
}

}  // namespace fathom::hidden
