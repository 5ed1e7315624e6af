// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/other_axes.h"

#include "fathom/findings/batch_means.h"
#include "fathom/simulate/partner_signals.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/parameters.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kWindow = 2.0;       // [s]
constexpr double kLeastShare = 0.25;  // of what the model misses
constexpr double kLeastErrors = 5.0;  // standard errors

using FactorPair = std::pair<Dof, Dof>;

// The products of the row of C(nu) nu with a diagonal M.
std::array<FactorPair, 2> ProductsIn(Dof dof) {
  switch (dof) {
    case Dof::kSurge:
      return {{{Dof::kSway, Dof::kYaw}, {Dof::kHeave, Dof::kPitch}}};
    case Dof::kSway:
      return {{{Dof::kSurge, Dof::kYaw}, {Dof::kHeave, Dof::kRoll}}};
    case Dof::kHeave:
      return {{{Dof::kSurge, Dof::kPitch}, {Dof::kSway, Dof::kRoll}}};
    case Dof::kRoll:
      return {{{Dof::kSway, Dof::kHeave}, {Dof::kPitch, Dof::kYaw}}};
    case Dof::kPitch:
      return {{{Dof::kSurge, Dof::kHeave}, {Dof::kRoll, Dof::kYaw}}};
    case Dof::kYaw:
      return {{{Dof::kSurge, Dof::kSway}, {Dof::kRoll, Dof::kPitch}}};
  }
  return {};
}

// Means over windows: acceleration, (tau, v|v|, v, 1) and the product.
struct Means {
  Eigen::VectorXd acceleration;
  Eigen::MatrixX4d regressors;
  Eigen::VectorXd product;
};

Means MeansOf(std::span<const Segment> segments, const Stream& stream, const FactorPair& factors) {
  const SampledSignal a = {stream.time, *stream.Find(VelocityColumn(factors.first))};
  const SampledSignal b = {stream.time, *stream.Find(VelocityColumn(factors.second))};
  using Row = Eigen::Array<double, 6, 1>;
  std::vector<Row> windows;
  for (const Segment& segment : segments) {
    if (segment.acceleration.empty()) continue;
    Row sum = Row::Zero();
    int count = 0;
    double from = segment.time.front();
    std::size_t place_a = 0, place_b = 0;
    for (std::size_t i = 0; i < segment.time.size(); ++i) {
      const double t = segment.time[i];
      if (t >= from + kWindow) {
        if (count > 1) windows.emplace_back(sum / count);
        sum.setZero();
        count = 0;
        from = t;
      }
      const double v = segment.smoothed_velocity[i];
      const double square =
          segment.smoothed_square.empty() ? v * std::abs(v) : segment.smoothed_square[i];
      Row row;
      row << segment.acceleration[i], segment.smoothed_force[i], square, v, 1.0,
          LineAt(a, t, &place_a).value * LineAt(b, t, &place_b).value;
      if (!row.allFinite()) continue;
      sum += row;
      ++count;
    }
    if (count > 1) windows.emplace_back(sum / count);
  }
  const auto n = static_cast<Eigen::Index>(windows.size());
  Means means = {Eigen::VectorXd(n), Eigen::MatrixX4d(n, 4), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Row& row = windows[static_cast<std::size_t>(i)];
    means.acceleration[i] = row[0];
    means.regressors.row(i) = row.segment<4>(1).matrix().transpose();
    means.product[i] = row[5];
  }
  return means;
}

// What the product does to the regression.
struct Gain {
  double share = 0.0;  // of what the model misses, explained by the product
  double inertia = 0.0, inertia_alone = 0.0;
};

// Nothing where the product cannot be told from nothing.
std::optional<Gain> GainOf(const Means& means) {
  constexpr double kLeastPivot = 1e-14;
  if (means.acceleration.size() <= 32) return std::nullopt;
  const Eigen::VectorXd scale = means.regressors.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixX4d X = means.regressors * scale.cwiseInverse().asDiagonal();
  if (RankOf(X, kLeastPivot) < 4) return std::nullopt;
  const Eigen::Vector4d alone = LeastSquares(X, means.acceleration);
  const Eigen::Vector4d of_product = LeastSquares(X, means.product);
  const Eigen::VectorXd missed = means.acceleration - X * alone;
  const Eigen::VectorXd product = means.product - X * of_product;
  const double size = product.squaredNorm();
  if (!(size > 1e-9 * means.product.squaredNorm() && missed.squaredNorm() > 0.0)) {
    return std::nullopt;
  }
  const double factor = product.dot(missed) / size;
  const Eigen::ArrayXd left = (missed - factor * product).array();
  const double error =
      ErrorOfMean(product.array() * left) / (size / static_cast<double>(product.size()));
  if (!(std::abs(factor) > kLeastErrors * error)) return std::nullopt;
  return Gain{factor * factor * size / missed.squaredNorm(),
              scale[0] / (alone[0] - factor * of_product[0]),
              scale[0] / alone[0]};
}

std::string OnInertia(const Gain& gain, const std::string& unit) {
  if (!(gain.inertia > 0.0 && gain.inertia_alone > 0.0)) return "";
  return fmt::format(" By least squares the inertia is {:.3g} {} with it and {:.3g} {} without.",
                     gain.inertia,
                     unit,
                     gain.inertia_alone,
                     unit);
}

}  // namespace

std::optional<Finding> CheckOtherAxes(const Log& log, Dof dof, std::span<const Segment> segments) {
  if (!log.velocity) return std::nullopt;
  const std::string unit = ParameterUnit(
      kInertia, dof, log.command_unit.empty() ? std::string(ForceUnit(dof)) : log.command_unit);
  std::optional<Finding> finding;
  double largest = kLeastShare;
  for (const FactorPair& factors : ProductsIn(dof)) {
    const std::string_view a = VelocityColumn(factors.first), b = VelocityColumn(factors.second);
    if (log.velocity->Find(a) == nullptr || log.velocity->Find(b) == nullptr) continue;
    const std::optional<Gain> gain = GainOf(MeansOf(segments, *log.velocity, factors));
    if (!gain || !(gain->share > largest)) continue;
    largest = gain->share;
    finding = Finding{
        Severity::kNote,
        "other_axes",
        fmt::format("Other axes act on this one: {} times {} explains {:.0f} % of what a model of "
                    "{} alone misses over {:g} s.{}",
                    a,
                    b,
                    100.0 * gain->share,
                    Name(dof),
                    kWindow,
                    OnInertia(*gain, unit))};
  }
  return finding;
}

}  // namespace fathom
