// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a .zip begins with an array of numpy.
bool LooksLikeNpz(std::string_view first_bytes);

// An array of numpy is a channel: a .npy is called as its file, each array of a .npz by its name.
// Samples run along the longer dimension. A vector has the field `value`, a column of an array its
// number from 1, a structured array the fields of its elements. A field time, Time or t of these,
// or the only date, holds the stamps. Memory: one array of 200 MB at most. Throws InputError for a
// file whose header or directory is damaged.
std::unique_ptr<Recording> OpenNpy(const std::filesystem::path& path);
std::unique_ptr<Recording> OpenNpz(const std::filesystem::path& path);

}  // namespace fathom
