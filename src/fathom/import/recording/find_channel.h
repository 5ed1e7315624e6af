// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <string>

namespace fathom {

// The channel of a selection, which has each of its fields. Throws InputError, naming the file and
// what there is instead.
const Channel& FindChannel(const Contents& contents,
                           const std::filesystem::path& path,
                           const Selection& selection);

}  // namespace fathom
