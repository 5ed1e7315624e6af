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

std::vector<Record> Part(const std::vector<Record>& records, bool held_out) {
  std::vector<Record> part;
  for (const Record& record : records) {
    if (record.is_held_out == held_out) part.push_back(record);
  }
  return part;
}

size_t NumSamples(const std::vector<Record>& records) {
  size_t count = 0;
  for (const Record& record : records) count += record.velocity.size() + record.displacement.size();
  return count;
}

}  // namespace

Preparation Prepare(const Records& records, Dof dof) {
  Preparation preparation;
  std::vector<Record> train = Part(records.all, false);
  const auto start = FindRobustStart(train);
  if (!start) {
    preparation.message = fmt::format(
        "output error finds no physical baseline model along {}, and without one there is nothing "
        "to diagnose. fathom_identify says why.",
        Name(dof));
    return preparation;
  }
  preparation.num_outliers = RemoveOutliers(start->model, start->initial, &train);
  std::vector<Record> thinned = Thinned(train);
  if (NumSamples(thinned) < kLeastSamples) {
    preparation.message = fmt::format(
        "the training data are {} samples (at 10 Hz at most), expected at least {}: with fewer, "
        "structure cannot be told from noise.",
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
                                        Part(records.all, true),
                                        std::move(baseline),
                                        std::move(users)});
  return preparation;
}

}  // namespace fathom
