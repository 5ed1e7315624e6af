// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// A sentence as a headline shows it: names of effects and of the baseline's parameters with spaces
// ("thruster lag"), quotation marks for backticks. Names within paths and flags are left alone.
std::string InWords(std::string_view sentence);

}  // namespace fathom
