// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/coupled/drawn_coupled_models.h"

#include "fathom/base/input_error.h"
#include "fathom/solve/covariance_factor.h"

#include <cstddef>

#include <fmt/format.h>

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
  return model;
}

}  // namespace

std::vector<CoupledModel> DrawCoupledModels(const FittedCoupledModel& fitted,
                                            int count,
                                            const std::string& name,
                                            RandomStream& random) {
  if (!fitted.covariance.allFinite() || fitted.covariance.diagonal().minCoeff() < 0.0) {
    throw InputError(
        fmt::format("{}: the covariance of the parameters is not known, expected one: limits are "
                    "kept by the models that the log allows. fathom_identify writes it.",
                    name));
  }
  const Eigen::MatrixXd factor = CovarianceFactor(fitted.covariance);
  const bool is_passive = IsPassive(fitted.model);
  const auto is_physical = [&](const CoupledModel& model) {
    return IsPositiveDefinite(model.inertia, model.dofs) && (!is_passive || IsPassive(model));
  };
  std::vector<CoupledModel> models;
  while (static_cast<int>(models.size()) < count) {
    CoupledModel drawn = DrawnModel(fitted, factor, random);
    for (int trial = 1; trial < kMostDraws && !is_physical(drawn); ++trial) {
      drawn = DrawnModel(fitted, factor, random);
    }
    if (!is_physical(drawn)) {
      throw InputError(fmt::format(
          "{}: nearly all models within its intervals are impossible (inertia or damping below 0), "
          "expected a model that its log determines: fly some steps first.",
          name));
    }
    models.push_back(drawn);
  }
  return models;
}

}  // namespace fathom
