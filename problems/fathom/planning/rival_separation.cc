// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/rival_separation.h"

#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

// Of Levenberg's damping, added to the squares of unit columns.
constexpr int kMostRuns = 24;
constexpr double kFirstDamping = 1e-6;
constexpr double kLeastDamping = 1e-10;  // what leaves no trace of its own stays
constexpr double kMostDamping = 1e3;
constexpr double kProgress = 1e-4;  // of the squares, below which a refit ends

// What is measured of a motion: velocities, and positions where there are any, in their standard
// deviations.
Eigen::VectorXd MeasuredOf(const PlannedMotion& motion, const RunSetting& setting) {
  const auto column = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  };
  if (!setting.noise.MeasuresPosition()) return column(motion.velocity) / setting.noise.velocity;
  Eigen::VectorXd both(motion.velocity.size() + motion.displacement.size());
  both << column(motion.velocity) / setting.noise.velocity,
      column(motion.displacement) / setting.noise.position;
  return both;
}

// The same of derivatives; a velocity does not depend on the position at the start.
struct MeasuredColumns {
  Eigen::MatrixXd by_parameter, by_start;
};
MeasuredColumns MeasuredOf(const MotionDerivatives& derivatives, const RunSetting& setting) {
  if (!setting.noise.MeasuresPosition()) {
    return {derivatives.by_parameter / setting.noise.velocity,
            derivatives.by_start / setting.noise.velocity};
  }
  const Eigen::Index num_rows = derivatives.by_parameter.rows();
  MeasuredColumns columns;
  columns.by_parameter.resize(2 * num_rows, derivatives.by_parameter.cols());
  columns.by_parameter << derivatives.by_parameter / setting.noise.velocity,
      derivatives.displacement_by_parameter / setting.noise.position;
  columns.by_start.resize(2 * num_rows, derivatives.displacement_by_start.cols());
  columns.by_start << derivatives.by_start / setting.noise.velocity,
      Eigen::VectorXd::Zero(num_rows), derivatives.displacement_by_start / setting.noise.position;
  return columns;
}

// The range that each parameter may have, in the order of MotionDerivatives.
struct ParameterBox {
  Eigen::VectorXd value, lower, upper;
};
ParameterBox BoxOf(const ExtendedModel& model) {
  std::vector<double> value, lower, upper;
  const ParameterVector baseline = ToVector(model.baseline);
  for (int i = 0; i < kNumParameters; ++i) {
    value.push_back(baseline[i]);
    lower.push_back(i == kInertia ? 0.1 * baseline[i] : kParameterInfo[i].lower_bound);
    upper.push_back(std::numeric_limits<double>::infinity());
  }
  for (const ActiveEffect& active : model.effects) {
    for (std::size_t k = 0; k < active.values.size(); ++k) {
      value.push_back(active.values[k]);
      lower.push_back(active.effect->info().parameters[k].lower);
      upper.push_back(active.effect->info().parameters[k].upper);
    }
  }
  const auto column = [](const std::vector<double>& values) {
    return Eigen::VectorXd(
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  return {column(value), column(lower), column(upper)};
}

// The model with parameters moved, within what they can be.
ExtendedModel MovedModel(ExtendedModel model, const Eigen::VectorXd& step) {
  const ParameterBox box = BoxOf(model);
  const Eigen::VectorXd moved = (box.value + step).cwiseMax(box.lower).cwiseMin(box.upper);
  model.baseline = ModelFromVector(moved.head(kNumParameters));
  Eigen::Index index = kNumParameters;
  for (ActiveEffect& active : model.effects) {
    for (double& value : active.values) value = moved[index++];
  }
  return model;
}

// A model's run, linear in its parameters and its start. The start is eliminated: the columns are
// what it cannot imitate of the parameters'.
class LinearRun {
 public:
  // Nothing if it diverges.
  static std::optional<LinearRun> Of(const ExtendedModel& model, const RunSetting& setting) {
    MotionDerivatives derivatives;
    const auto motion =
        MotionUnder(model, setting.dof, setting.command, setting.stamps, &derivatives);
    if (!motion) return std::nullopt;
    LinearRun run;
    run.box_ = BoxOf(model);
    run.measured_ = MeasuredOf(*motion, setting);
    const MeasuredColumns columns = MeasuredOf(derivatives, setting);
    run.start_ = PivotedQr(columns.by_start);
    run.num_start_ = run.start_.Rank();
    run.columns_ = run.WithoutStart(columns.by_parameter);
    run.scales_ = run.columns_.colwise().norm().cwiseMax(1e-12).cwiseInverse();
    run.columns_ *= run.scales_.asDiagonal();
    run.normal_ = run.columns_.transpose() * run.columns_;
    return run;
  }

  const Eigen::VectorXd& measured() const { return measured_; }

  // What a start cannot imitate: the rows of Q' behind the start's, as long as the rest.
  Eigen::MatrixXd WithoutStart(const Eigen::MatrixXd& columns) const {
    const Eigen::MatrixXd turned = start_.TransposedQTimes(columns);
    return turned.bottomRows(turned.rows() - num_start_);
  }

  // What is left of a motion that this one misses.
  Eigen::VectorXd LeftOf(const Eigen::VectorXd& measured) const {
    return WithoutStart(measured - measured_);
  }

  // The damped step of the parameters towards what is left. Those that it would carry out of their
  // range are held on its end while the others are solved for again.
  struct Step {
    Eigen::VectorXd parameters;
    double sigmas = 0.0;  // that stay in the linear forecast
  };
  Step Towards(const Eigen::VectorXd& left, double damping) const {
    const Eigen::Index size = columns_.cols();
    Eigen::VectorXd step = Eigen::VectorXd::Zero(size);  // of unit columns
    std::vector<bool> is_held(static_cast<std::size_t>(size), false);
    for (Eigen::Index trial = 0; trial <= size; ++trial) {
      Eigen::MatrixXd normal = normal_;
      normal.diagonal().array() += damping;
      Eigen::VectorXd right = columns_.transpose() * left;
      for (Eigen::Index i = 0; i < size; ++i) {
        if (!is_held[static_cast<std::size_t>(i)]) continue;
        right -= step[i] * normal_.col(i);
      }
      for (Eigen::Index i = 0; i < size; ++i) {
        if (!is_held[static_cast<std::size_t>(i)]) continue;
        normal.row(i).setZero();
        normal.col(i).setZero();
        normal(i, i) = 1.0;
        right[i] = step[i];
      }
      step = normal.llt().solve(right);
      bool is_inside = true;
      for (Eigen::Index i = 0; i < size; ++i) {
        if (is_held[static_cast<std::size_t>(i)]) continue;
        const double low = (box_.lower[i] - box_.value[i]) / scales_[i];
        const double high = (box_.upper[i] - box_.value[i]) / scales_[i];
        if (step[i] >= low && step[i] <= high) continue;
        step[i] = std::clamp(step[i], low, high);
        is_held[static_cast<std::size_t>(i)] = true;
        is_inside = false;
      }
      if (is_inside) break;
    }
    return {scales_.cwiseProduct(step), (left - columns_ * step).norm()};
  }

 private:
  ParameterBox box_;
  Eigen::VectorXd measured_;
  PivotedQr start_;
  Eigen::Index num_start_ = 0;
  Eigen::MatrixXd columns_;  // of unit length
  Eigen::VectorXd scales_;   // that made them so
  Eigen::MatrixXd normal_;
};

}  // namespace

RefittedModel RefitTo(const PlannedMotion& motion,
                      const ExtendedModel& assumed,
                      const RunSetting& setting) {
  const Eigen::VectorXd truth = MeasuredOf(motion, setting);
  RefittedModel best = {assumed, std::numeric_limits<double>::infinity()};
  std::optional<LinearRun> at = LinearRun::Of(assumed, setting);
  if (!at) return best;
  Eigen::VectorXd left = at->LeftOf(truth);
  best.sigmas = left.norm();
  double damping = kFirstDamping;
  for (int run = 1; run < kMostRuns && damping < kMostDamping; ++run) {
    const LinearRun::Step step = at->Towards(left, damping);
    const ExtendedModel moved = MovedModel(best.model, step.parameters);
    std::optional<LinearRun> tried = LinearRun::Of(moved, setting);
    const Eigen::VectorXd left_then = tried ? tried->LeftOf(truth) : left;
    const double sigmas = left_then.norm();
    if (!tried || !(sigmas < best.sigmas)) {
      if (best.sigmas - step.sigmas < kProgress * best.sigmas) break;
      damping *= 30.0;
      continue;
    }
    const double progress = 1.0 - sigmas * sigmas / (best.sigmas * best.sigmas);
    best = {moved, sigmas};
    at = std::move(tried);
    left = left_then;
    damping = std::max(kLeastDamping, 0.1 * damping);
    if (progress < kProgress) break;
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

// Where a step is long, its forecast and the run behind it disagree, and either may be far too
// great: a search would live on what a better refit explains. The smaller counts.
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
    const Eigen::VectorXd& measured = runs[truth].measured();
    for (std::size_t assumed = 0; assumed < runs.size(); ++assumed) {
      if (assumed == truth) continue;
      const LinearRun& run = runs[assumed];
      const LinearRun::Step step = run.Towards(run.LeftOf(measured), kFirstDamping);
      const auto moved = MotionUnder(MovedModel(rivals[assumed].model, step.parameters),
                                     setting.dof,
                                     setting.command,
                                     setting.stamps);
      if (!moved) return {};
      const double behind = run.WithoutStart(measured - MeasuredOf(*moved, setting)).norm();
      sigmas.push_back(std::min(step.sigmas, behind));
    }
  }
  return sigmas;
}

}  // namespace fathom
