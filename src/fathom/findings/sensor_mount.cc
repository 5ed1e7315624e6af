// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/sensor_mount.h"

#include "fathom/findings/block_regression.h"
#include "fathom/findings/twin_motion.h"
#include "fathom/findings/twist_scale.h"
#include "fathom/signal/pose_velocity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastLinear = 0.02;  // [m/s] and [m/s^2] std
constexpr double kLeastTurn = 0.05;    // [rad/s] std
constexpr double kLeastWindows = 30.0;
constexpr double kTakenAway = 0.8;  // of what the two do not share is left
constexpr double kLeastAngle = 3.0 * std::numbers::pi / 180.0;

// What the poses say: u v w p q r, and the derivatives of the first three.
enum Signal { kU, kV, kW, kP, kQ, kR, kDu, kDv, kDw, kSignals };

// What is to be found: of the sensor's axes seen along the vehicle's, the three scales and the sine
// of its angle; the arm [m]; of each column a constant and what its delay is still off [s].
enum Parameter {
  kScale = 0,
  kSine = 3,
  kArm = 4,
  kConstant = 7,
  kDelay = 10,
  kParameters = 13,
};

// The terms of docs/findings.md (12).
struct Term {
  int axis;
  Signal signal;
  double sign;
  int parameter;
};
constexpr Term kTerms[] = {
    {0, kU, 1, kScale},
    {0, kV, 1, kSine},
    {0, kR, -1, kArm + 1},
    {0, kQ, 1, kArm + 2},
    {0, kDu, -1, kDelay},
    {1, kV, 1, kScale + 1},
    {1, kU, -1, kSine},
    {1, kR, 1, kArm},
    {1, kP, -1, kArm + 2},
    {1, kDv, -1, kDelay + 1},
    {2, kW, 1, kScale + 2},
    {2, kQ, -1, kArm},
    {2, kP, 1, kArm + 1},
    {2, kDw, -1, kDelay + 2},
};

struct Curve {
  std::vector<double> values, instrument;  // at the stamps of the poses
  bool moves = false;
};

std::vector<Curve> CurvesOf(const std::vector<double>& time,
                            const BodyVelocity& body,
                            double window) {
  std::vector<Curve> curves(kSignals);
  for (int k = 0; k < kDu; ++k) {
    for (std::size_t i = 0; i < time.size(); ++i) {
      curves[k].values.push_back(body.is_centred[i] ? body.velocity[i][k] : kUnknown);
    }
  }
  for (int k = kDu; k < kSignals; ++k) {
    const std::vector<double>& of = curves[k - kDu].values;
    for (const double t : time) {
      curves[k].values.push_back((ValueAt(time, of, t + window / 2.0, window) -
                                  ValueAt(time, of, t - window / 2.0, window)) /
                                 window);
    }
  }
  for (int k = 0; k < kSignals; ++k) {
    curves[k].moves =
        SpreadOf(curves[k].values) >= (k >= kP && k <= kR ? kLeastTurn : kLeastLinear);
    // The noise of a derivative reaches over two windows.
    if (curves[k].moves) {
      curves[k].instrument = InstrumentOf(time, curves[k].values, k >= kDu ? 2.0 * window : window);
    }
  }
  return curves;
}

// All rows of all columns, in the order of time.
struct SensorRows {
  Eigen::MatrixXd regressors, instruments;
  Eigen::VectorXd observed;
  std::array<double, 3> squares = {};  // of what was observed, about the mean of each column
};

SensorRows RowsOf(const std::vector<Curve>& curves,
                  const std::vector<std::vector<double>>& twist,
                  std::size_t size) {
  std::vector<std::size_t> stamps;
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_known =
        std::ranges::all_of(twist,
                            [&](const auto& of) { return of.empty() || std::isfinite(of[i]); }) &&
        std::ranges::all_of(curves, [&](const Curve& curve) {
          return !curve.moves ||
                 (std::isfinite(curve.values[i]) && std::isfinite(curve.instrument[i]));
        });
    if (is_known) stamps.push_back(i);
  }
  std::vector<int> axes;
  for (int axis = 0; axis < 3; ++axis) {
    if (!twist[axis].empty()) axes.push_back(axis);
  }
  const auto count = static_cast<Eigen::Index>(stamps.size() * axes.size());
  SensorRows rows = {Eigen::MatrixXd::Zero(count, kParameters),
                     Eigen::MatrixXd::Zero(count, kParameters),
                     Eigen::VectorXd::Zero(count)};
  Eigen::Index row = 0;
  for (const std::size_t i : stamps) {
    for (const int axis : axes) {
      for (const Term& term : kTerms) {
        const Curve& curve = curves[term.signal];
        if (term.axis != axis || !curve.moves) continue;
        rows.regressors(row, term.parameter) += term.sign * curve.values[i];
        rows.instruments(row, term.parameter) += term.sign * curve.instrument[i];
      }
      rows.regressors(row, kConstant + axis) = 1.0;
      rows.instruments(row, kConstant + axis) = 1.0;
      rows.observed[row++] = twist[axis][i];
    }
  }
  for (const int axis : axes) {
    const Eigen::ArrayXd is_of = rows.regressors.col(kConstant + axis).array();
    const Eigen::ArrayXd of = rows.observed.array() * is_of;
    rows.squares[axis] = of.square().sum() - of.sum() * of.sum() / is_of.sum();
  }
  return rows;
}

// The regression with some of the parameters; the others are not known.
BlockRegression Regress(const SensorRows& rows, const std::set<int>& parameters) {
  const std::vector<int> kept(parameters.begin(), parameters.end());
  BlockRegression fit = RegressByBlocks(
      rows.regressors(Eigen::all, kept), rows.instruments(Eigen::all, kept), rows.observed);
  BlockRegression all = {Eigen::VectorXd::Constant(kParameters, kUnknown),
                         Eigen::VectorXd::Constant(kParameters, kUnknown),
                         fit.squares};
  all.theta(kept) = fit.theta;
  all.half_width(kept) = fit.half_width;
  return all;
}

// Whether the fit needs these parameters.
bool TakesAway(const BlockRegression& fit,
               const SensorRows& rows,
               std::set<int> parameters,
               const std::vector<int>& less) {
  for (const int parameter : less) parameters.erase(parameter);
  return fit.squares < kTakenAway * Regress(rows, parameters).squares;
}

// atan of sine over cosine, of the mean scale along surge and sway.
MountEstimate AngleOf(const BlockRegression& fit) {
  double cosine = 0.0, half_width = 0.0, n = 0.0;
  for (const int k : {kScale + 0, kScale + 1}) {
    if (!std::isfinite(fit.theta[k])) continue;
    cosine += fit.theta[k];
    half_width += fit.half_width[k];
    n += 1.0;
  }
  cosine /= n;
  half_width /= n;
  const double sine = fit.theta[kSine];
  return {std::atan2(sine, cosine),
          std::hypot(cosine * fit.half_width[kSine], sine * half_width) /
              (sine * sine + cosine * cosine)};
}

// From the axes of the sensor, which is turned by `angle`, to those of the vehicle.
std::array<MountEstimate, 3> ArmsOf(const BlockRegression& fit, double angle) {
  std::array<MountEstimate, 3> arms;
  for (int k = 0; k < 3; ++k) arms[k] = {fit.theta[kArm + k], fit.half_width[kArm + k]};
  if (!std::isfinite(arms[0].value) || !std::isfinite(arms[1].value)) return arms;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto [x, y] = std::pair(arms[0], arms[1]);
  arms[0] = {c * x.value - s * y.value, std::hypot(c * x.half_width, s * y.half_width)};
  arms[1] = {s * x.value + c * y.value, std::hypot(s * x.half_width, c * y.half_width)};
  return arms;
}

}  // namespace

std::optional<SensorMount> SensorMountOf(const Log& log, const std::vector<LateColumn>& columns) {
  if (!log.pose || !log.velocity || columns.empty()) return std::nullopt;
  const Stream& pose = *log.pose;
  const Stream& velocity = *log.velocity;
  if (!TellsMotion(pose, Dof::kSurge) || !TellsMotion(pose, Dof::kYaw)) return std::nullopt;
  const SavitzkyGolayOptions options = TwinFilter(log);
  const double window = options.window;
  const BodyVelocity body = VelocityOf(PosesOf(pose), options);
  const std::vector<Curve> curves = CurvesOf(pose.time, body, window);

  std::vector<std::vector<double>> twist(3);
  double num_columns = 0.0;
  for (const LateColumn& column : columns) {
    const std::vector<double>* values = velocity.Find(VelocityColumn(column.dof));
    if (values == nullptr || IsAngular(column.dof)) continue;
    const std::vector<double> smooth = SmoothTwist(velocity.time, *values, options);
    for (const double t : pose.time) {
      twist[Index(column.dof)].push_back(ValueAt(velocity.time, smooth, t + column.delay, window));
    }
    num_columns += 1.0;
  }
  const SensorRows rows = RowsOf(curves, twist, pose.time.size());
  const double seconds = static_cast<double>(rows.observed.size()) / std::max(1.0, num_columns) *
                         (pose.time.back() - pose.time.front()) /
                         static_cast<double>(pose.time.size());
  if (!(seconds >= kLeastWindows * window)) return std::nullopt;

  std::set<int> parameters;
  for (int k = 0; k < kParameters; ++k) {
    if (k == kSine && (twist[0].empty() || twist[1].empty())) continue;
    if ((rows.regressors.col(k).array() != 0.0).any()) parameters.insert(k);
  }
  const BlockRegression fit = Regress(rows, parameters);
  if (!(fit.squares <
        SensorMount::kMostMissed * (rows.squares[0] + rows.squares[1] + rows.squares[2]))) {
    return std::nullopt;
  }

  SensorMount mount;
  mount.angle = AngleOf(fit);
  mount.needs_angle = mount.angle.IsOver(kLeastAngle) && TakesAway(fit, rows, parameters, {kSine});
  mount.arm = ArmsOf(fit, mount.needs_angle ? mount.angle.value : 0.0);
  mount.needs_arm = TakesAway(fit, rows, parameters, {kArm, kArm + 1, kArm + 2});
  const Eigen::VectorXd known =
      fit.theta.unaryExpr([](double theta) { return std::isfinite(theta) ? theta : 0.0; });
  const Eigen::ArrayXd error = rows.observed - rows.regressors * known;
  for (int axis = 0; axis < 3; ++axis) {
    if (twist[axis].empty()) continue;
    mount.missed[axis] =
        (error * rows.regressors.col(kConstant + axis).array()).square().sum() / rows.squares[axis];
  }
  return mount;
}

}  // namespace fathom
