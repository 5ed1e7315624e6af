// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdio>
#include <string>

namespace fathom {

// Writes the text to the stream. On a terminal its lines are at most 100 columns, see
// WrappedText(); in a pipe or a file each stays one line, so that grep finds it whole.
void PrintText(std::FILE* stream, const std::string& text);

}  // namespace fathom
