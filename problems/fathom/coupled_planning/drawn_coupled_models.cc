// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/drawn_coupled_models.h"

#include "fathom/planning/drawn_models.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <cstddef>
#include <utility>

namespace fathom {
namespace {

constexpr int kMostDraws = 300;  // of one model

CoupledModel ModelAt(const FittedCoupledModel& fitted, const Eigen::VectorXd& step) {
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
  const bool is_passive = IsPassive(fitted.model);
  const auto is_physical = [&](const CoupledModel& model) {
    return IsPositiveDefinite(model.inertia, model.dofs) && (!is_passive || IsPassive(model)) &&
           model.thruster_lag >= 0.0;
  };
  std::vector<CoupledModel> models;
  DrawSteps({fitted.covariance, name, count, kMostDraws}, random, [&](const Eigen::VectorXd& step) {
    CoupledModel drawn = ModelAt(fitted, step);
    if (!is_physical(drawn)) return false;
    models.push_back(std::move(drawn));
    return true;
  });
  return models;
}

}  // namespace fathom
