// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace fathom {

// Whether the first line of a text names the columns of a single CSV log: t, tau and v, whatever
// else.
bool IsSingleCsvLog(std::string_view text);

}  // namespace fathom
