// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>

namespace fathom {

// The decimal number that is the whole of `text`: "-1.5", "2e-3", ".5". Nothing for anything else,
// so also for spaces around it, a leading '+', "nan", "inf" and numbers beyond the range of a
// double.
std::optional<double> ParseFiniteNumber(std::string_view text);

}  // namespace fathom
