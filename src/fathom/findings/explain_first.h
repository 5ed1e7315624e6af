// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"

#include <string>
#include <vector>

namespace fathom {

// What comes before any other sentence where there are warnings, empty where there is none: "One
// red finding has to be explained before a model of this log can be believed."
std::string ExplainFirst(const std::vector<Finding>& findings);

}  // namespace fathom
