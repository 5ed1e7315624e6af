// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/matlab/matlab_file.h"
#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <memory>

namespace fathom {

// A .mat as a recording; docs/import_mat.md. A channel is an array of numbers with two dimensions:
// its samples run along the longer one, its fields are called 1, 2, ..., or "value" if there is
// one. It has no stamps. A struct with a field time, Time or t is one channel of all its fields
// with as many samples as that, which is their stamp [s].
std::unique_ptr<Recording> OpenMatlab(const std::filesystem::path& path,
                                      std::unique_ptr<MatlabFile> file);

}  // namespace fathom
