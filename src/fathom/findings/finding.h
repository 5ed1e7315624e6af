// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

enum class Severity {
  kNote,     // worth knowing
  kWarning,  // no fit of these data should be believed before this is explained
};

// Where in a log a finding shows.
struct FindingPlace {
  std::string file;   // "velocity.csv"
  std::string axis;   // its column, "yaw" of a pose; empty: the command of the DOF
  TimeInterval time;  // the first row and the last one, or of a jump those beside it [s]
};

// What is odd about data, or about a model in the light of what is known of the vehicle.
struct Finding {
  Severity severity = Severity::kNote;
  std::string code;                        // one word for programs: "passivity"
  std::string sentence;                    // for a person, with its figures
  std::optional<FindingPlace> where = {};  // absent: it is about the whole log
};

// The warnings before the notes, otherwise in their order.
std::vector<Finding> WarningsFirst(std::vector<Finding> findings);

// Whether there is one of this code.
bool Has(const std::vector<Finding>& findings, const std::string& code);

}  // namespace fathom
