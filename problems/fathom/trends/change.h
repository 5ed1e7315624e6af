// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

enum class ChangeKind { kStep, kTrend };

// "step" or "trend".
std::string_view Name(ChangeKind kind);

// `parameter` of a coupled model's number that no model of one DOF has.
inline constexpr int kNoParameter = -1;

// Whether two records are of the same number.
template <typename A, typename B>
bool AreOfOneSeries(const A& a, const B& b) {
  return a.dof == b.dof && a.parameter == b.parameter && a.entry == b.entry;
}

// A parameter that does not stay what it was over the dives.
struct Change {
  Dof dof = Dof::kSurge;
  int parameter = 0;  // index in kParameterInfo, or kNoParameter
  ChangeKind kind = ChangeKind::kStep;
  int at = 0;  // the first dive after a step; of a trend, the first dive
  double before =
      std::numeric_limits<double>::quiet_NaN();             // mean before a step; the trend's value
  double after = std::numeric_limits<double>::quiet_NaN();  // at the first dive and at the last
  double before_std = std::numeric_limits<double>::quiet_NaN();
  double after_std = std::numeric_limits<double>::quiet_NaN();
  double p_value = std::numeric_limits<double>::quiet_NaN();  // over the whole archive at once
  std::optional<FreeEntry> entry = {};                        // of a coupled model
};

// Changes that one cause explains together.
struct ChangeEvent {
  std::vector<Change> changes;            // at least one
  std::string cause;                      // docs/archive_trends.md: "payload", ... "unnamed"
  std::vector<std::string> alternatives;  // causes that these dives cannot tell from it
  std::string text;                       // one sentence for a person
};

}  // namespace fathom
