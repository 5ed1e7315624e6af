// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/momentum_balance.h"

#include "fathom/base/median.h"
#include "fathom/signal/filters/savitzky_golay.h"
#include "fathom/simulate/partner_signals.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/effect_stack.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kBalancePiece = 2.0;   // [s]
constexpr std::size_t kLeastPiece = 8;  // samples

struct Motion {
  std::vector<double> time, velocity, position;
};

// Velocity and position, each from the other where it was not measured. A vehicle's poses are
// smoothed over the window that predicts left-out samples best.
Motion MotionOf(const MeasuredSegment& segment) {
  Motion motion;
  if (segment.velocity.empty()) {
    motion.time = segment.stamps.displacement;
    motion.position = segment.displacement;
    const double step = MedianStep(motion.time);
    SavitzkyGolayOptions options;
    options.window =
        ChooseWindow(motion.time, motion.position, options.order, 4.5 * step, 80.5 * step);
    motion.velocity = SavitzkyGolay(motion.time, motion.position, 1, options);
    return motion;
  }
  motion.time = segment.stamps.velocity;
  motion.velocity = segment.velocity;
  double position = segment.initial.position;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    if (i > 0) {
      position += 0.5 * (motion.time[i] - motion.time[i - 1]) *
                  (motion.velocity[i - 1] + motion.velocity[i]);
    }
    motion.position.push_back(position);
  }
  return motion;
}

// Where the vehicle is at rest for several samples: dry friction then is whatever the other forces
// are, and tells nothing.
std::vector<bool> RestOf(const std::vector<double>& velocity) {
  constexpr double kRest = 0.02;  // of the RMS speed
  constexpr std::size_t kFewest = 4;
  double sum = 0.0, n = 0.0;
  for (const double v : velocity) {
    if (!std::isfinite(v)) continue;
    sum += v * v;
    n += 1.0;
  }
  const double slow = kRest * std::sqrt(sum / std::max(1.0, n));
  std::vector<bool> rest(velocity.size(), false);
  for (std::size_t i = 0; i < velocity.size();) {
    std::size_t end = i;
    while (end < velocity.size() && std::abs(velocity[end]) < slow) ++end;
    if (end - i >= kFewest) std::fill(rest.begin() + i, rest.begin() + end, true);
    i = std::max(end, i + 1);
  }
  return rest;
}

// The integral over time of what acts at mid-interval, given times its interval, less its mean.
std::vector<double> Integrated(const std::vector<double>& impulses) {
  std::vector<double> integral(impulses.size(), 0.0);
  double sum = 0.0, mean = 0.0;
  for (std::size_t i = 1; i < impulses.size(); ++i) {
    integral[i] = sum += impulses[i];
    mean += sum / static_cast<double>(impulses.size());
  }
  for (double& value : integral) value -= mean;
  return integral;
}

// Solves for the columns of which `signs` asks to be at least 0, one that is not left out at a
// time.
Eigen::VectorXd Solved(const Eigen::MatrixXd& A,
                       const Eigen::VectorXd& g,
                       std::span<const int> at_least_zero) {
  std::vector<bool> is_out(g.size(), false);
  for (;;) {
    Eigen::MatrixXd held = A;
    Eigen::VectorXd right = g;
    for (Eigen::Index j = 0; j < g.size(); ++j) {
      if (!is_out[j]) continue;
      held.row(j).setZero();
      held.col(j).setZero();
      held(j, j) = 1.0;
      right[j] = 0.0;
    }
    const Eigen::VectorXd scale = held.diagonal().cwiseSqrt().cwiseMax(1e-150).cwiseInverse();
    Eigen::MatrixXd scaled = scale.asDiagonal() * held * scale.asDiagonal();
    scaled.diagonal().array() += 1e-9;
    Eigen::VectorXd solution =
        scale.asDiagonal() * SolveSymmetric(scaled, scale.asDiagonal() * right);
    const auto negative = std::find_if(at_least_zero.begin(), at_least_zero.end(), [&](int j) {
      return !is_out[j] && solution[j] < 0.0;
    });
    if (negative == at_least_zero.end()) return solution;
    is_out[*negative] = true;
  }
}

}  // namespace

MomentumBalance::MomentumBalance(std::span<const MeasuredSegment> segments) {
  for (const MeasuredSegment& segment : segments) {
    const Motion motion = MotionOf(segment);
    const std::vector<bool> rest = RestOf(motion.velocity);
    std::size_t begin = 0;
    while (begin < motion.time.size()) {
      Piece piece;
      piece.segment = &segment;
      std::size_t i = begin;
      for (; i < motion.time.size(); ++i) {
        const bool is_long =
            motion.time[i] - motion.time[begin] > kBalancePiece && i - begin >= kLeastPiece;
        if (is_long || rest[i] || !std::isfinite(motion.velocity[i])) break;
        piece.time.push_back(motion.time[i]);
        piece.velocity.push_back(motion.velocity[i]);
        piece.position.push_back(motion.position[i]);
      }
      begin = std::max(i, begin + 1);
      if (piece.time.size() >= 5) pieces_.push_back(std::move(piece));
    }
  }
}

bool MomentumBalance::HasForce(const Effect& effect) {
  const EffectLaw<double>& law = effect.law<double>();
  return (law.delay || law.thrust || law.follow || law.thrust_at_speed || law.resistance) &&
         !law.relative_speed && !law.memory_rate;
}

// The mean force over the interval that ends at each sample, times its length.
std::vector<double> MomentumBalance::ForceOf(const Piece& piece, const ActiveEffect* effect) const {
  const EffectInputs& inputs = *piece.segment->inputs;
  std::vector<StackedEffect<double>> stacked;
  PartnerSignals partner;
  const bool acts = effect && effect->setting.ActsIn(piece.segment->log);
  if (acts) {
    const bool has_partner = effect->effect->info().has_partner();
    stacked.push_back(
        {&effect->effect->law<double>(), effect->setting, has_partner, effect->values});
    if (has_partner) partner = PartnerSignals(inputs, effect->setting);
  }
  const EffectStack<double> stack(std::move(stacked));
  const double delay = stack.Delay();
  const double time_zero = inputs.command.time.empty() ? 0.0 : inputs.command.time.front();
  double state = inputs.command.At(piece.time.front() - delay);
  std::vector<double> impulse(piece.time.size(), 0.0);
  for (std::size_t i = 1; i < piece.time.size(); ++i) {
    const double from = piece.time[i - 1], to = piece.time[i], middle = 0.5 * (from + to);
    const double speed = 0.5 * (piece.velocity[i - 1] + piece.velocity[i]);
    Instant<double> now;
    now.time = middle - time_zero;
    if (!partner.empty()) now.partner = partner.At(middle, middle, from);
    const auto at = [&](std::size_t) { return now; };
    const HeldCommand held = inputs.command.Between(from - delay, to - delay);
    double sum = 0.0;
    for (std::size_t k = 0; k < held.time.size(); ++k) {
      const double begin = std::max(held.time[k], from - delay);
      const double end = k + 1 < held.time.size() ? held.time[k + 1] : to - delay;
      if (!(end > begin)) continue;
      const double mean = stack.MeanForce(held.value[k], end - begin, at, &state);
      sum += (end - begin) * stack.ForceAtSpeed(mean, speed);
    }
    WaterState<double> water;
    water.speed = water.relative_speed = speed;
    water.position = 0.5 * (piece.position[i - 1] + piece.position[i]);
    impulse[i] = sum - (to - from) * stack.Resistance(&water, nullptr, at);
  }
  return impulse;
}

// The columns of one piece, less their means: the force's, the baseline's others, and one for each
// amount of `probe` beyond `base`.
Eigen::MatrixXd MomentumBalance::ColumnsOf(const Piece& piece,
                                           const ActiveEffect* base,
                                           const ActiveEffect* probe,
                                           std::span<const std::size_t> amounts) const {
  const std::size_t n = piece.time.size();
  std::vector<double> square(n, 0.0), way(n, 0.0), time(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    const double h = piece.time[i] - piece.time[i - 1];
    const double v = 0.5 * (piece.velocity[i] + piece.velocity[i - 1]);
    square[i] = -h * v * std::abs(v);
    way[i] = -h * v;
    time[i] = -h;
  }
  const std::vector<double> force = ForceOf(piece, base);
  std::vector<std::vector<double>> columns = {
      Integrated(force), Integrated(square), Integrated(way), Integrated(time)};
  for (const std::size_t amount : amounts) {
    ActiveEffect probed = *base;
    probed.values[amount] = probe->values[amount];
    std::vector<double> more = ForceOf(piece, &probed);
    for (std::size_t i = 0; i < n; ++i) more[i] -= force[i];
    columns.push_back(Integrated(more));
  }
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(n), std::ssize(columns));
  for (Eigen::Index j = 0; j < rows.cols(); ++j) {
    rows.col(j) = Eigen::Map<const Eigen::VectorXd>(columns[j].data(), rows.rows());
  }
  return rows;
}

std::optional<MomentumFit> MomentumBalance::Solve(const ActiveEffect* effect) const {
  std::vector<std::size_t> amounts;
  ActiveEffect base;
  if (effect) {
    base = *effect;
    const auto& parameters = effect->effect->info().parameters;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      if (parameters[k].search != Search::kAmount) continue;
      amounts.push_back(k);
      base.values[k] = parameters[k].null;
    }
  }
  const auto num_columns = static_cast<Eigen::Index>(kNumParameters + amounts.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(num_columns, num_columns);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(num_columns);
  MomentumFit fit;
  for (const Piece& piece : pieces_) {
    const Eigen::MatrixXd rows = ColumnsOf(piece, effect ? &base : nullptr, effect, amounts);
    Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(piece.velocity.data(), rows.rows());
    y.array() -= y.mean();
    A += rows.transpose() * rows;
    g += rows.transpose() * y;
    fit.squared_error += y.squaredNorm();
    fit.num_samples += static_cast<int>(rows.rows());
  }
  if (fit.num_samples <= num_columns) return std::nullopt;
  constexpr int kDampings[] = {kQuadraticDamping, kLinearDamping};
  const Eigen::VectorXd ratio = Solved(A, g, kDampings);  // to the inertia
  if (!(ratio[0] > 0.0) || !ratio.allFinite()) return std::nullopt;
  const double inertia = 1.0 / ratio[0];
  fit.model.baseline = {inertia,
                        ratio[kQuadraticDamping] * inertia,
                        ratio[kLinearDamping] * inertia,
                        ratio[kBuoyancy] * inertia};
  fit.squared_error += ratio.dot(A * ratio) - 2.0 * ratio.dot(g);
  if (!effect) return fit;
  for (std::size_t k = 0; k < amounts.size(); ++k) {
    const EffectParameter& p = effect->effect->info().parameters[amounts[k]];
    const double share = ratio[static_cast<Eigen::Index>(kNumParameters + k)] * inertia;
    const double way = effect->values[amounts[k]] - p.null;
    base.values[amounts[k]] = std::clamp(p.null + share * way, p.lower, p.upper);
  }
  fit.model = WithEffect(std::move(fit.model), std::move(base));
  return fit;
}

std::optional<MomentumFit> MomentumBalance::FitInertiaAlone() const {
  constexpr double kDampingRate = 0.1;  // [1/s], of a vehicle that is not slowed down in a second
  double push = 0.0, change = 0.0;
  MomentumFit fit;
  for (const Piece& piece : pieces_) {
    const std::vector<double> force = ForceOf(piece, nullptr);
    for (std::size_t i = 1; i < force.size(); ++i) {
      push += std::abs(force[i]);
      change += std::abs(piece.velocity[i] - piece.velocity[i - 1]);
    }
    fit.num_samples += static_cast<int>(force.size());
  }
  if (!(push > 0.0) || !(change > 0.0)) return std::nullopt;
  const double inertia = push / change;
  fit.model.baseline = {inertia, 0.0, kDampingRate * inertia, 0.0};
  return fit;
}

std::optional<MomentumFit> MomentumBalance::Fit() const {
  auto fit = Solve(nullptr);
  return fit ? fit : FitInertiaAlone();
}

std::optional<MomentumFit> MomentumBalance::FitWith(const ActiveEffect& effect) const {
  return HasForce(*effect.effect) ? Solve(&effect) : std::nullopt;
}

}  // namespace fathom
