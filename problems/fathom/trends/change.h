// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

enum class ChangeKind { kStep, kTrend };

// "step" or "trend".
std::string_view Name(ChangeKind kind);

// A parameter of one DOF that does not stay what it was over the dives.
struct Change {
  Dof dof = Dof::kSurge;
  int parameter = 0;  // index in kParameterInfo
  ChangeKind kind = ChangeKind::kStep;
  int at = 0;  // the first dive after a step; of a trend, the first dive
  double before =
      std::numeric_limits<double>::quiet_NaN();             // mean before a step; the trend's value
  double after = std::numeric_limits<double>::quiet_NaN();  // at the first dive and at the last
  double before_std = std::numeric_limits<double>::quiet_NaN();
  double after_std = std::numeric_limits<double>::quiet_NaN();
  double p_value = std::numeric_limits<double>::quiet_NaN();  // over the whole archive at once
};

// Changes that one cause explains together.
struct ChangeEvent {
  std::vector<Change> changes;            // at least one
  std::string cause;                      // docs/archive_trends.md: "payload", ... "unnamed"
  std::vector<std::string> alternatives;  // causes that these dives cannot tell from it
  std::string text;                       // one sentence for a person
};

}  // namespace fathom
