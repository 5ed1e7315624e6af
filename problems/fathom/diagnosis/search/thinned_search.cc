// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/thinned_search.h"

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

// The least inertia that a fit may try, of the baseline's or output error's, whichever is smaller.
// Where the baseline leaves it open it is no measure: kLeastInertiaIfOpen.
constexpr double kLeastInertia = 0.1;

bool IsInertiaOpen(const StructureFit& fit) {
  const double std = std::sqrt(fit.covariance(kInertia, kInertia));
  return !fit.is_on_bound[kInertia] && !(std < fit.model.baseline.inertia);
}

}  // namespace

SearchResult SearchThinned(const Prepared& prepared,
                           const std::vector<Suspect>& suspects,
                           const DiagnosisOptions& wanted) {
  const StructureFit& baseline = prepared.baseline;
  const double inertia =
      std::min(baseline.model.baseline.inertia, prepared.users.model.baseline.inertia);
  const double share = IsInertiaOpen(baseline) ? kLeastInertiaIfOpen : kLeastInertia;
  const TrainingData thinned(prepared.thinned, baseline.model.baseline, share * inertia);
  const StructureFit rough =
      FitStructureAndNoise(thinned, baseline.model, baseline.initial, baseline.noise);
  return SearchCauses(thinned, rough.IsSimulated() ? rough : baseline, suspects, wanted);
}

}  // namespace fathom
