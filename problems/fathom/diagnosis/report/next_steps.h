// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <string>
#include <vector>

namespace fathom {

// What to do about each cause, after a caution where the data held out may gain nothing by them,
// and what would decide between those that cannot be told apart; or, where no cause is named, what
// that means. A sentence or two each.
std::vector<std::string> NextSteps(const Diagnosis& diagnosis);

}  // namespace fathom
