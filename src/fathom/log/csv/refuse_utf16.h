// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// Throws InputError, with the command that converts it, for a text in UTF-16, as spreadsheets save
// "Unicode text": by its byte order mark, or by a first line of two ASCII characters or more.
void RefuseUtf16(const std::string& name, std::string_view text);

}  // namespace fathom
