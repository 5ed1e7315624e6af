// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/finding.h"

#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace fathom {

// [{severity, code, sentence}], as every file has them: severity "red" for a warning, else
// "yellow".
nlohmann::ordered_json JsonOf(const std::vector<Finding>& findings);

}  // namespace fathom
