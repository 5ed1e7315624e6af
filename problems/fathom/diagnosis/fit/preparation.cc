// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/preparation.h"

#include "fathom/diagnosis/data/thinned.h"
#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/outliers.h"
#include "fathom/diagnosis/fit/robust_start.h"

#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// About five for each unknown of a model with three causes.
constexpr size_t kLeastSamples = 60;

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

}  // namespace

Preparation Prepare(const MeasuredSegments& segments, Dof dof) {
  Preparation preparation;
  std::vector<MeasuredSegment> train = Part(segments.all, false);
  const auto start = FindRobustStart(train);
  if (!start) {
    preparation.message = fmt::format(
        "output error finds no physical baseline model for {}, so nothing can be diagnosed. "
        "fathom_identify says why.",
        Name(dof));
    return preparation;
  }
  preparation.num_outliers = RemoveOutliers(start->model, start->initial, &train);
  std::vector<MeasuredSegment> thinned = Thinned(train);
  if (NumSamples(thinned) < kLeastSamples) {
    preparation.message = fmt::format(
        "the training data have {} samples (at 10 Hz at most), expected at least {}: with fewer, "
        "structure cannot be separated from noise.",
        NumSamples(thinned),
        kLeastSamples);
    return preparation;
  }
  const UncoupledModel<double>& about = start->model.baseline;
  TrainingData data(std::move(train), about, kLeastInertiaIfOpen * about.inertia);
  StructureFit baseline = FitBaseline(data, start->model, start->initial);
  if (!baseline.IsSimulated()) {
    preparation.message = "the baseline model cannot be simulated over these logs.";
    return preparation;
  }
  StartedModel users = UsersModel(data, *start).value_or(StartedFrom(baseline));
  preparation.prepared.emplace(Prepared{std::move(data),
                                        std::move(thinned),
                                        Part(segments.all, true),
                                        std::move(baseline),
                                        std::move(users)});
  return preparation;
}

}  // namespace fathom
