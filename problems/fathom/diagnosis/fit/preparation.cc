// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/preparation.h"

#include "fathom/diagnosis/data/excerpt.h"
#include "fathom/diagnosis/data/thinned.h"
#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/least_inertia.h"
#include "fathom/diagnosis/fit/momentum_balance.h"
#include "fathom/diagnosis/fit/outliers.h"
#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/diagnosis/fit/search_data.h"
#include "fathom/diagnosis/fit/started_model.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// About five for each unknown of a model with three causes.
constexpr size_t kLeastSamples = 60;

// Of what is trained on: memory and time of the screen grow with both; docs/diagnosis.md (2).
constexpr double kMostTraining = 3600.0;      // [s]
constexpr double kMostOfSamples = 120'000.0;  // an hour at 33 Hz

std::vector<MeasuredSegment> Part(const std::vector<MeasuredSegment>& segments, bool held_out) {
  std::vector<MeasuredSegment> part;
  for (const MeasuredSegment& segment : segments) {
    if (segment.is_held_out == held_out) part.push_back(segment);
  }
  return part;
}

size_t NumSamples(const std::vector<MeasuredSegment>& segments) {
  size_t count = 0;
  for (const MeasuredSegment& segment : segments)
    count += segment.velocity.size() + segment.displacement.size();
  return count;
}

// Where the momentum along the measured motion puts the baseline.
std::optional<StartedModel> StartByMomentum(const std::vector<MeasuredSegment>& segments) {
  const auto fit = MomentumBalance(segments).Fit();
  if (!fit) return std::nullopt;
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  StartedModel start;
  start.model = fit->model;
  start.covariance = Eigen::MatrixXd::Constant(kNumParameters, kNumParameters, kUnknown);
  for (const MeasuredSegment& segment : segments) start.initial.push_back(segment.initial);
  return start;
}

// A model as it was started, not fitted; nothing if that cannot be simulated.
std::optional<StructureFit> Unfitted(const TrainingData& data, const StartedModel& start) {
  auto at = data.Linearise(start.model, start.initial);
  if (!at) return std::nullopt;
  StructureFit fit;
  fit.model = start.model;
  fit.initial = start.initial;
  fit.residual = data.measured() - at->simulated;
  fit.jacobian = std::move(at->jacobian);
  fit.covariance = start.covariance;
  fit.is_on_bound.assign(kNumParameters, false);
  fit.noise = WhiteNoise(data, fit.residual);
  fit.log_likelihood = Whitener(fit.noise, data.samples())
                           .LogLikelihood(std::span(fit.residual.data(), fit.residual.size()));
  return fit;
}

}  // namespace

Preparation Prepare(const MeasuredSegments& segments,
                    Dof dof,
                    const std::optional<IdentifiedModel>& identified) {
  Preparation preparation;
  std::vector<MeasuredSegment> train = Part(segments.all, false);
  preparation.duration = DurationOf(train);
  const double most_by_samples =
      preparation.duration * kMostOfSamples / static_cast<double>(NumSamples(train));
  train = Excerpt(std::move(train), std::min(kMostTraining, most_by_samples));
  preparation.used = DurationOf(train);
  const auto by_momentum = StartByMomentum(train);
  if (!by_momentum) {
    preparation.message = NoBaseline(dof);
    return preparation;
  }
  const double inertia_by_momentum = by_momentum->model.baseline.inertia;
  auto by_output_error = FindRobustStart(train);
  if (by_output_error && by_output_error->model.baseline.inertia > kRunAway * inertia_by_momentum) {
    by_output_error.reset();
  }
  if (by_output_error) {
    preparation.num_outliers =
        RemoveOutliers(by_output_error->model, by_output_error->initial, &train);
  }
  const std::size_t num_samples = NumSamples(Thinned(train, kFineWidth));
  if (num_samples < kLeastSamples) {
    preparation.message = fmt::format(
        "the training data have {} samples (at 10 Hz at most), expected at least {}: with fewer, "
        "structure cannot be separated from noise.",
        num_samples,
        kLeastSamples);
    return preparation;
  }
  const UncoupledModel<double>& about =
      (by_output_error ? by_output_error : by_momentum)->model.baseline;
  Prepared prepared = {TrainingData(std::move(train), about, kLeastInertiaIfOpen * about.inertia),
                       {},
                       Part(segments.all, true),
                       {},
                       {}};
  prepared.inertia_by_momentum = inertia_by_momentum;
  const TrainingData& data = prepared.data;
  if (by_output_error) {
    prepared.baseline = FitBaseline(data, by_output_error->model, by_output_error->initial);
    if (prepared.baseline.IsUsable()) {
      StartedModel users = *by_output_error;
      if (identified && identified->model.inertia <= kRunAway * inertia_by_momentum) {
        users.model.baseline = identified->model;
        users.covariance = identified->covariance;
      }
      prepared.users = UsersModel(data, users).value_or(StartedFrom(prepared.baseline));
    }
  }
  if (!prepared.baseline.IsUsable()) {
    prepared.why_no_baseline =
        prepared.baseline.IsSimulated() ? NotConverged(dof) : NoBaseline(dof);
    auto unfitted = Unfitted(data, *by_momentum);
    if (!unfitted) {
      preparation.message = prepared.why_no_baseline;
      return preparation;
    }
    prepared.has_baseline = false;
    prepared.users = StartedFrom(*unfitted);
    prepared.baseline = *std::move(unfitted);
  }
  prepared.thinned = SearchDataOf(data, prepared.baseline);
  preparation.prepared = std::move(prepared);
  return preparation;
}

std::string NoBaseline(Dof dof) {
  return fmt::format(
      "output error finds no physical baseline model for {}, and no effect that was tried makes up "
      "for it. fathom_identify says why.",
      Name(dof));
}

std::string NotConverged(Dof dof) {
  return fmt::format(
      "the search for a baseline model of {} took all steps that it may and did not converge, and "
      "no effect that was tried makes up for it.",
      Name(dof));
}

}  // namespace fathom
