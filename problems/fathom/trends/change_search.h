// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/change.h"
#include "fathom/trends/change_options.h"
#include "fathom/trends/column.h"
#include "fathom/trends/dive_estimate.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// A dive that does not fit what its series is otherwise.
struct ParameterOutlier {
  int dive = 0;
  Dof dof = Dof::kSurge;
  int parameter = 0;
  std::optional<FreeEntry> entry = {};  // of a coupled model

  bool operator==(const ParameterOutlier&) const = default;
};

// How much a parameter scatters between dives beyond their own intervals.
struct ScatterBetweenDives {
  Dof dof = Dof::kSurge;
  int parameter = 0;
  double std = 0.0;   // [unit of the parameter]
  int num_dives = 0;  // of the series, without outliers
  std::optional<FreeEntry> entry = {};
};

// A change that is in the model from the start.
struct KnownChange {
  Dof dof = Dof::kSurge;
  int parameter = 0;
  Column column;
  std::optional<FreeEntry> entry = {};
};

struct ChangeSearch {
  std::vector<Change> changes;  // by p-value, then DOF and parameter
  std::vector<ParameterOutlier> outliers;
  std::vector<ScatterBetweenDives> scatter;  // of every series that was searched
};

// What changes over the dives of a vehicle beyond `known`: docs/archive_trends.md (1) to (6).
//
// Each series, one number of a model, is a mean with steps, at most one linear trend, scatter
// between dives and the noise of each dive. In turn the most telling step, trend or outlying dive
// is added, as long as a quiet archive would show the like less often than the options allow.
// A series of fewer than five dives is not searched, and a step has two dives on either side.
//
// CHECKs the options. At most one estimate of each dive and DOF, a coupled one counting as that of
// all its DOFs; dives that are missing, NaN or
// have no positive variance are left out.
ChangeSearch FindChanges(std::span<const DiveEstimate> estimates,
                         int num_dives,
                         const ChangeOptions& options,
                         std::span<const KnownChange> known = {});

}  // namespace fathom
