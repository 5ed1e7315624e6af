// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/drawn_coupled_models.h"

#include "fathom/planning/drawn_models.h"

#include <cstddef>

namespace fathom {
namespace {

constexpr int kMostDraws = 300;  // of one model

CoupledModel DrawnModel(const FittedCoupledModel& fitted,
                        const Eigen::MatrixXd& factor,
                        RandomStream& random) {
  Eigen::VectorXd normal(factor.cols());
  for (double& value : normal) value = random.Normal();
  const Eigen::VectorXd step = factor * normal;
  CoupledModel model = fitted.model;
  for (std::size_t k = 0; k < fitted.entries.size(); ++k) {
    const FreeEntry& entry = fitted.entries[k];
    SetValue(entry, ValueIn(model, entry) + step[static_cast<Eigen::Index>(k)], &model);
  }
  model.time_offset = fitted.model.time_offset;
  return model;
}

}  // namespace

std::vector<CoupledModel> DrawCoupledModels(const FittedCoupledModel& fitted,
                                            int count,
                                            const std::string& name,
                                            RandomStream& random) {
  const Eigen::MatrixXd factor = KnownFactor(fitted.covariance, name);
  const bool is_passive = IsPassive(fitted.model);
  const auto is_physical = [&](const CoupledModel& model) {
    return IsPositiveDefinite(model.inertia, model.dofs) && (!is_passive || IsPassive(model)) &&
           model.thruster_lag >= 0.0;
  };
  std::vector<CoupledModel> models;
  while (static_cast<int>(models.size()) < count) {
    CoupledModel drawn = DrawnModel(fitted, factor, random);
    for (int trial = 1; trial < kMostDraws && !is_physical(drawn); ++trial) {
      drawn = DrawnModel(fitted, factor, random);
    }
    if (!is_physical(drawn)) {
      RefuseDraws(name);
    }
    models.push_back(drawn);
  }
  return models;
}

}  // namespace fathom
