// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <string>

namespace fathom {

// What a recording holds as JSON; docs/file_formats.md.
std::string FormatContents(const Contents& contents);

}  // namespace fathom
