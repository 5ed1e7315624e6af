// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_forecast.h"

#include "fathom/base/median.h"
#include "fathom/base/parallel_for.h"
#include "fathom/base/quantile.h"
#include "fathom/planning/flown_information.h"
#include "fathom/planning/information.h"
#include "fathom/planning/kept_limits.h"
#include "fathom/planning/named_parameters.h"
#include "fathom/planning/rival_separation.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

// What is known by a run of each model that the log allows; nothing by one that diverges.
std::vector<Eigen::MatrixXd> InformationUnder(const PlanRequest& request,
                                              std::span<const ExtendedModel> models,
                                              const HeldCommand& command,
                                              std::span<const double> stamps,
                                              const StampNoise& noise) {
  const auto num_parameters = request.model.covariance.rows();
  std::vector<Eigen::MatrixXd> of_models(models.size(),
                                         Eigen::MatrixXd::Zero(num_parameters, num_parameters));
  ParallelFor(static_cast<int>(models.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    MotionDerivatives derivatives;
    if (!MotionUnder(models[k], request.model.dof, command, stamps, &derivatives)) return;
    of_models[k] = InformationOf(derivatives, noise);
  });
  return of_models;
}

// The standard deviations with `known` beside a run: medians over what the run may tell.
Eigen::VectorXd MedianStds(const Eigen::MatrixXd& known,
                           const std::vector<Eigen::MatrixXd>& of_run) {
  std::vector<std::vector<double>> stds(static_cast<std::size_t>(known.rows()));
  for (const Eigen::MatrixXd& information : of_run) {
    const Eigen::VectorXd variances = InverseOf(known + information).diagonal();
    for (Eigen::Index p = 0; p < known.rows(); ++p) {
      stds[static_cast<std::size_t>(p)].push_back(std::sqrt(variances[p]));
    }
  }
  Eigen::VectorXd medians(known.rows());
  for (Eigen::Index p = 0; p < known.rows(); ++p) {
    medians[p] = Median(std::move(stds[static_cast<std::size_t>(p)]));
  }
  return medians;
}

// Between the quantiles of 2.5 and 97.5 % at each stamp.
PlannedBand BandOf(const std::vector<double>& nominal,
                   const std::vector<std::vector<double>>& runs) {
  PlannedBand band = {nominal, {}, {}};
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    std::vector<double> values;
    for (const std::vector<double>& run : runs) values.push_back(run[i]);
    band.low.push_back(Quantile(values, 0.025));
    band.high.push_back(Quantile(values, 0.975));
  }
  return band;
}

// That 95 % of runs stay in: each end is passed by 2.5 % of them.
ValueRange RangeOf(const std::vector<std::vector<double>>& runs) {
  std::vector<double> lows, highs;
  for (const std::vector<double>& run : runs) {
    lows.push_back(std::min(0.0, *std::min_element(run.begin(), run.end())));
    highs.push_back(std::max(0.0, *std::max_element(run.begin(), run.end())));
  }
  return {Quantile(lows, 0.025), Quantile(highs, 0.975)};
}

}  // namespace

void ForecastParameters(const PlanRequest& request,
                        std::span<const ExtendedModel> models,
                        std::span<const double> stamps,
                        const StampNoise& noise,
                        ExperimentPlan* plan) {
  const Eigen::MatrixXd flown = FlownInformation(request);
  const Eigen::MatrixXd of_model = InverseOf(request.model.covariance);
  // Without logs, the model's own to the bit.
  const Eigen::MatrixXd before =
      request.flown.empty() ? request.model.covariance : InverseOf(of_model + flown);
  const std::vector<Eigen::MatrixXd> planned =
      InformationUnder(request, models, plan->command, stamps, noise);
  const Eigen::VectorXd after = MedianStds(flown, planned);
  const Eigen::VectorXd both = MedianStds(of_model + flown, planned);
  const Eigen::VectorXd by_sine =
      MedianStds(flown, InformationUnder(request, models, plan->sine.command, stamps, noise));
  plan->parameters = NamedParameters(request.model);
  Eigen::Index i = 0;
  for (PlannedParameter& parameter : plan->parameters) {
    parameter.before = std::sqrt(before(i, i));
    parameter.after = after[i];
    parameter.with_log_so_far = both[i];
    parameter.sine = by_sine[i];
    ++i;
  }
}

void ForecastSeparations(const PlanRequest& request,
                         const std::vector<RivalModel>& rivals,
                         std::span<const double> stamps,
                         const StampNoise& noise,
                         ExperimentPlan* plan) {
  const Dof dof = request.model.dof;
  const auto separation = [&](const RivalModel& truth,
                              const RivalModel& assumed,
                              const HeldCommand& command,
                              const StampNoise& of_stamps) {
    const auto motion = MotionUnder(truth.model, dof, command, stamps);
    if (!motion) return 0.0;
    return RefitTo(*motion, assumed.model, {dof, command, stamps, of_stamps}).sigmas;
  };
  StampNoise with_positions = noise;
  with_positions.position = AdvisedPositionNoise(dof);
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    for (std::size_t k = 0; k < rivals.size(); ++k) {
      if (k == i) continue;
      plan->separations.push_back({rivals[i].label,
                                   rivals[k].label,
                                   separation(rivals[i], rivals[k], plan->command, noise),
                                   separation(rivals[i], rivals[k], plan->sine.command, noise)});
      PlannedSeparation& pair = plan->separations.back();
      if (noise.MeasuresPosition() || pair.IsDecided()) continue;
      pair.with_positions = separation(rivals[i], rivals[k], plan->command, with_positions);
    }
  }
  for (const RivalModel& rival : rivals) {
    const int num_breaking =
        NumBreaking({&rival.model, 1}, dof, plan->command, plan->time, request.limits, 1);
    if (num_breaking > 0) plan->breaking_rivals.push_back(rival.label);
  }
}

bool ForecastMotion(const PlanRequest& request,
                    std::span<const ExtendedModel> models,
                    std::span<const double> stamps,
                    ExperimentPlan* plan) {
  const Dof dof = request.model.dof;
  const auto nominal = MotionUnder(request.model.Extended(), dof, plan->command, stamps);
  if (!nominal) return false;
  std::vector<std::vector<double>> speeds, displacements;
  int num_breaking = 0;
  for (const ExtendedModel& model : models) {
    auto motion = MotionUnder(model, dof, plan->command, stamps);
    if (!motion || !KeepsLimits(*motion, request.limits)) ++num_breaking;
    if (!motion) continue;
    speeds.push_back(std::move(motion->velocity));
    displacements.push_back(std::move(motion->displacement));
  }
  plan->num_models = static_cast<int>(models.size());
  plan->share_breaking = static_cast<double>(num_breaking) / plan->num_models;
  if (speeds.empty()) return false;
  plan->time = {stamps.begin(), stamps.end()};
  plan->speed = BandOf(nominal->velocity, speeds);
  plan->displacement = BandOf(nominal->displacement, displacements);
  plan->speed_range = RangeOf(speeds);
  plan->distance_range = RangeOf(displacements);
  return true;
}

}  // namespace fathom
