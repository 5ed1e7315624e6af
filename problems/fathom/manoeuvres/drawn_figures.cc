// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/drawn_figures.h"

#include "fathom/base/quantile.h"
#include "fathom/base/random_stream.h"
#include "fathom/solve/covariance_factor.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Core>

namespace fathom {
namespace {

// How the offsets scatter from run to run, by those that the model knows of single runs: another
// run has one too.
Vector6 RunScatter(const FittedCoupledModel& fitted) {
  Vector6 squares = Vector6::Zero();
  for (const auto& [run, offset] : fitted.model.run_offset) squares += offset.cwiseAbs2();
  const double num_others = static_cast<double>(fitted.log_fingerprints.size()) - 1.0;
  return (squares / std::max(num_others, 1.0)).cwiseSqrt();
}

}  // namespace

std::vector<CoupledModel> DrawModels(const FittedCoupledModel& fitted,
                                     int count,
                                     std::uint64_t seed) {
  const Eigen::MatrixXd root = CovarianceFactor(fitted.covariance);
  const Vector6 scatter = RunScatter(fitted);
  RandomStream random(seed, "manoeuvre");
  std::vector<CoupledModel> models;
  for (int i = 0; i < count; ++i) {
    Eigen::VectorXd normal(root.cols());
    for (double& value : normal) value = random.Normal();
    const Eigen::VectorXd move = root * normal;
    CoupledModel& model = models.emplace_back(fitted.model);
    for (std::size_t k = 0; k < fitted.entries.size(); ++k) {
      const FreeEntry& entry = fitted.entries[k];
      const double value = ValueIn(model, entry) + move[static_cast<Eigen::Index>(k)];
      if (IsLimit(entry) && !MayBe(entry, value)) continue;
      SetValue(entry, IsLag(entry) ? std::max(value, 0.0) : value, &model);
    }
    if (scatter.isZero(0.0)) continue;
    for (Eigen::Index i = 0; i < 6; ++i) model.offset[i] += scatter[i] * random.Normal();
  }
  return models;
}

std::vector<FigureInterval> IntervalsOf(const std::vector<ManoeuvreFigures>& drawn,
                                        std::size_t num_figures) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<FigureInterval> intervals;
  for (std::size_t f = 0; f < num_figures; ++f) {
    std::vector<double> values;
    for (const ManoeuvreFigures& figures : drawn) {
      if (figures && std::isfinite((*figures)[f].value)) values.push_back((*figures)[f].value);
    }
    const double enough = kEnoughDraws * static_cast<double>(drawn.size());
    if (values.empty() || static_cast<double>(values.size()) < enough) {
      intervals.push_back({kUnknown, kUnknown});
    } else {
      intervals.push_back({Quantile(values, 0.025), Quantile(values, 0.975)});
    }
  }
  return intervals;
}

}  // namespace fathom
