// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Calls `take_row` with each row of a CSV text, in order: its line, counted from 1, and its cells
// without the quotes and spaces around them; they last for the call. Rows do not span lines.
//
// Throws InputError, naming `name` and the line, for an empty text, a byte order mark, NUL bytes,
// carriage returns, lines above 64 KiB, empty lines and quotes that are not closed or stand inside
// a cell.
void ForEachCsvRow(
    const std::string& name,
    const std::string& text,
    const std::function<void(int line, const std::vector<std::string_view>& cells)>& take_row);

}  // namespace fathom
