// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/drawn_models.h"

#include "fathom/base/input_error.h"
#include "fathom/solve/covariance_factor.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kMostTrials = 200;  // of one draw

// With these parameters in place of its own; nothing if they are not physical.
std::optional<ExtendedModel> WithParameters(ExtendedModel model, const Eigen::VectorXd& values) {
  const ParameterVector baseline = values.head(kNumParameters);
  for (int i = 0; i < kNumParameters; ++i) {
    if (baseline[i] < kParameterInfo[i].lower_bound) return std::nullopt;
  }
  if (!(baseline[kInertia] > 0.0)) return std::nullopt;
  model.baseline = ModelFromVector(baseline);
  Eigen::Index index = kNumParameters;
  for (ActiveEffect& active : model.effects) {
    for (std::size_t k = 0; k < active.values.size(); ++k) {
      const EffectParameter& parameter = active.effect->info().parameters[k];
      const double value = values[index++];
      if (value < parameter.lower || value > parameter.upper) return std::nullopt;
      active.values[k] = value;
    }
  }
  return model;
}

Eigen::VectorXd ValuesOf(const ExtendedModel& model) {
  const ParameterVector baseline = ToVector(model.baseline);
  std::vector<double> values(baseline.data(), baseline.data() + kNumParameters);
  for (const ActiveEffect& active : model.effects) {
    values.insert(values.end(), active.values.begin(), active.values.end());
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::MatrixXd KnownFactor(const Eigen::MatrixXd& covariance, const std::string& name) {
  if (!covariance.allFinite() || covariance.diagonal().minCoeff() < 0.0) {
    throw InputError(
        fmt::format("{}: the covariance of the parameters is not known, expected one: limits are "
                    "kept by the models that the log allows. fathom_identify writes it.",
                    name));
  }
  return CovarianceFactor(covariance);
}

}  // namespace

void DrawSteps(const DrawnSteps& of,
               RandomStream& random,
               const std::function<bool(const Eigen::VectorXd&)>& take) {
  const Eigen::MatrixXd factor = KnownFactor(of.covariance, of.name);
  Eigen::VectorXd normal(factor.cols());
  const auto is_taken = [&] {
    for (double& value : normal) value = random.Normal();
    return take(factor * normal);
  };
  for (int i = 0; i < of.count; ++i) {
    int trial = 1;
    while (!is_taken()) {
      if (++trial <= of.most_trials) continue;
      throw InputError(fmt::format(
          "{}: nearly all models within its intervals are impossible (inertia or damping below 0), "
          "expected a model that its log determines: fly some steps first.",
          of.name));
    }
  }
}

std::vector<ExtendedModel> DrawModels(const FittedModel& fitted,
                                      int count,
                                      const std::string& name,
                                      RandomStream& random) {
  const Eigen::VectorXd centre = ValuesOf(fitted.Extended());
  std::vector<ExtendedModel> models;
  DrawSteps(
      {fitted.covariance, name, count, kMostTrials}, random, [&](const Eigen::VectorXd& step) {
        auto drawn = WithParameters(fitted.Extended(), centre + step);
        if (drawn) models.push_back(*std::move(drawn));
        return drawn.has_value();
      });
  return models;
}

}  // namespace fathom
