// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace fathom {

// Whether the first line of a text names the columns of a single CSV log: t, tau and v, whatever
// else.
bool IsSingleCsvLog(std::string_view text);

// Whether it names t and v and nothing else: a free decay. A further column may be a force with a
// mistake in its name.
bool IsSingleCsvDecay(std::string_view text);

// Whether it names two of them at least, perhaps with units or behind a byte order mark: one with a
// mistake rather than another program's file.
bool IsMeantAsSingleCsvLog(std::string_view text);

}  // namespace fathom
