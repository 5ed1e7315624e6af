// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace fathom {

// Whether a text stands for a number that is not finite: "nan", "inf" or "infinity", with any sign
// and in any case.
bool MeansNoFiniteNumber(std::string_view text);

}  // namespace fathom
