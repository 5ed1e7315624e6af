// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/twist_scale.h"

#include "fathom/findings/block_regression.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Core>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLags[] = {1.25, 2.0, 3.0};  // [windows]
constexpr std::size_t kFewestScaleRows = 50;

double MeanOf(std::span<const double> values) {
  double sum = 0.0, n = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    n += 1.0;
  }
  return sum / n;
}

}  // namespace

std::vector<double> InstrumentOf(std::span<const double> time,
                                 std::span<const double> values,
                                 double window) {
  const double mean = MeanOf(values);
  std::vector<double> best;
  double best_likeness = -1.0;
  for (const double lag : kLags) {
    std::vector<double> shifted;
    double squares = 0.0, product = 0.0, n = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double z = ValueAt(time, values, time[i] - lag * window, window) +
                       ValueAt(time, values, time[i] + lag * window, window) - 2.0 * mean;
      shifted.push_back(z);
      if (!std::isfinite(z) || !std::isfinite(values[i])) continue;
      squares += z * z;
      product += z * (values[i] - mean);
      n += 1.0;
    }
    const double likeness = squares > 0.0 ? std::abs(product) / std::sqrt(squares * n) : 0.0;
    if (!(likeness > best_likeness)) continue;
    best_likeness = likeness;
    best = std::move(shifted);
  }
  return best;
}

TwistScale TwistScaleOf(const TwinMotion& motion, double delay) {
  const std::vector<double> twist = AtPoses(motion, delay);
  // The noise of the poses is not in it, and that of the twist of another time.
  const std::vector<double> instrument = InstrumentOf(motion.pose_time, twist, motion.window);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < twist.size(); ++i) {
    if (std::isfinite(twist[i]) && std::isfinite(motion.from_pose[i]) &&
        std::isfinite(instrument[i])) {
      rows.push_back(i);
    }
  }
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (rows.size() < kFewestScaleRows) return {kNan, kNan};
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd x = Eigen::MatrixXd::Ones(count, 2), z = x;
  Eigen::VectorXd y(count);
  for (Eigen::Index row = 0; row < count; ++row) {
    const std::size_t i = rows[static_cast<std::size_t>(row)];
    x(row, 0) = motion.from_pose[i];
    z(row, 0) = instrument[i];
    y[row] = twist[i];
  }
  const BlockRegression fit = RegressByBlocks(x, z, y);
  return {fit.theta[0], fit.half_width[0]};
}

std::string FormatTwistScale(const TwistScale& scale) {
  if (!std::isfinite(scale.half_width)) return fmt::format("{:.3g}", scale.factor);
  return fmt::format("{:.3g} ({:.3g} to {:.3g})",
                     scale.factor,
                     scale.factor - scale.half_width,
                     scale.factor + scale.half_width);
}

}  // namespace fathom
