// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/matlab/matlab_file.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is a .mat of version 5, 6 or 7, which all have one
// form.
bool LooksLikeMat5(std::string_view first_bytes);

// Such a .mat, of either byte order; its variables may be compressed. The form is that of
// scipy/io/matlab/_mio5.py: behind a header of 128 bytes elements with a type and a length; an
// array is an element of elements.
std::unique_ptr<MatlabFile> OpenMat5(const std::filesystem::path& path);

}  // namespace fathom
