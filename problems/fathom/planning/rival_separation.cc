// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/rival_separation.h"

#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr int kMostRefits = 8;
constexpr double kRidge = 1e-10;  // of unit columns: what leaves no trace of its own stays

Eigen::VectorXd VelocityOf(const PlannedMotion& motion) {
  return Eigen::Map<const Eigen::VectorXd>(motion.velocity.data(),
                                           static_cast<Eigen::Index>(motion.velocity.size()));
}

// The model with parameters moved, within what they can be.
ExtendedModel MovedModel(ExtendedModel model, const Eigen::VectorXd& step) {
  ParameterVector baseline = ToVector(model.baseline);
  for (int i = 0; i < kNumParameters; ++i) {
    const double least = i == kInertia ? 0.1 * baseline[i] : kParameterInfo[i].lower_bound;
    baseline[i] = std::max(baseline[i] + step[i], least);
  }
  model.baseline = ModelFromVector(baseline);
  Eigen::Index index = kNumParameters;
  for (ActiveEffect& active : model.effects) {
    for (std::size_t k = 0; k < active.values.size(); ++k) {
      const EffectParameter& parameter = active.effect->info().parameters[k];
      active.values[k] =
          std::clamp(active.values[k] + step[index++], parameter.lower, parameter.upper);
    }
  }
  return model;
}

// A model's run, linear in its parameters and its start.
class LinearRun {
 public:
  // Nothing if it diverges.
  static std::optional<LinearRun> Of(const ExtendedModel& model, const RunSetting& setting) {
    LinearRun run;
    MotionDerivatives derivatives;
    auto motion = MotionUnder(model, setting.dof, setting.command, setting.stamps, &derivatives);
    if (!motion) return std::nullopt;
    run.motion_ = *std::move(motion);
    run.num_parameters_ = derivatives.by_parameter.cols();
    run.columns_.resize(derivatives.by_parameter.rows(),
                        run.num_parameters_ + derivatives.by_start.cols());
    run.columns_ << derivatives.by_parameter, derivatives.by_start;
    run.scales_ = run.columns_.colwise().norm().cwiseMax(1e-12).cwiseInverse();
    run.columns_ *= run.scales_.asDiagonal();
    Eigen::MatrixXd normal = run.columns_.transpose() * run.columns_;
    normal.diagonal().array() += kRidge;
    run.factor_.compute(normal);
    return run;
  }

  const PlannedMotion& motion() const { return motion_; }

  // The Gauss-Newton step towards a motion: of the parameters, and what the start takes up of the
  // velocities.
  struct Step {
    Eigen::VectorXd parameters, of_start;
  };
  Step Towards(const Eigen::VectorXd& velocity) const {
    const Eigen::VectorXd step =
        factor_.solve(columns_.transpose() * (velocity - VelocityOf(motion_)));
    const Eigen::Index num_start = step.size() - num_parameters_;
    return {scales_.cwiseProduct(step).head(num_parameters_),
            columns_.rightCols(num_start) * step.tail(num_start)};
  }

 private:
  PlannedMotion motion_;
  Eigen::MatrixXd columns_;  // of unit length
  Eigen::VectorXd scales_;   // that made them so
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::Index num_parameters_ = 0;
};

}  // namespace

RefittedModel RefitTo(const PlannedMotion& motion,
                      const ExtendedModel& assumed,
                      const RunSetting& setting) {
  const Eigen::VectorXd truth = VelocityOf(motion);
  RefittedModel best = {assumed, std::numeric_limits<double>::infinity()};
  ExtendedModel model = assumed;
  for (int refit = 0; refit < kMostRefits; ++refit) {
    const auto run = LinearRun::Of(model, setting);
    if (!run) break;
    const LinearRun::Step step = run->Towards(truth);
    const double sigmas =
        (truth - VelocityOf(run->motion()) - step.of_start).norm() / setting.noise;
    if (sigmas > best.sigmas) break;
    best = {model, sigmas};
    model = MovedModel(std::move(model), step.parameters);
  }
  return best;
}

std::vector<RivalModel> AgreeingRivals(std::vector<RivalModel> rivals, const RunSetting& setting) {
  if (rivals.empty()) return rivals;
  const auto motion =
      MotionUnder(rivals.front().model, setting.dof, setting.command, setting.stamps);
  if (!motion) return rivals;
  for (std::size_t k = 1; k < rivals.size(); ++k) {
    rivals[k].model = RefitTo(*motion, rivals[k].model, setting).model;
  }
  return rivals;
}

std::vector<double> QuickSeparations(std::span<const RivalModel> rivals,
                                     const RunSetting& setting) {
  std::vector<LinearRun> runs;
  for (const RivalModel& rival : rivals) {
    auto run = LinearRun::Of(rival.model, setting);
    if (!run) return {};
    runs.push_back(*std::move(run));
  }
  std::vector<double> sigmas;
  for (std::size_t truth = 0; truth < runs.size(); ++truth) {
    const Eigen::VectorXd velocity = VelocityOf(runs[truth].motion());
    for (std::size_t assumed = 0; assumed < runs.size(); ++assumed) {
      if (assumed == truth) continue;
      const LinearRun::Step step = runs[assumed].Towards(velocity);
      const auto moved = MotionUnder(MovedModel(rivals[assumed].model, step.parameters),
                                     setting.dof,
                                     setting.command,
                                     setting.stamps);
      if (!moved) return {};
      sigmas.push_back((velocity - VelocityOf(*moved) - step.of_start).norm() / setting.noise);
    }
  }
  return sigmas;
}

}  // namespace fathom
