// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/matlab/matlab_file.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is a .mat of version 4. It has no signature: the
// header of its first variable has to make sense.
bool LooksLikeMat4(std::string_view first_bytes);

// A .mat of version 4, of either byte order. The form is that of scipy/io/matlab/_mio4.py: for each
// variable a header of 20 bytes, its name, and its numbers column by column. Throws InputError for
// a file that does not begin with a variable.
std::unique_ptr<MatlabFile> OpenMat4(const std::filesystem::path& path);

}  // namespace fathom
