// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/matlab/matlab_file.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is a file of HDF5, as a .mat of version 7.3 is: at
// its begin, or behind the 512 bytes of MATLAB's header.
bool LooksLikeMat73(std::string_view first_bytes);

// A .mat of version 7.3, or another file of HDF5 with arrays in groups. Dimensions are in MATLAB's
// order, which is the reverse of HDF5's. The HDF5 library opens only whole files. Throws InputError
// for any that it does not open.
std::unique_ptr<MatlabFile> OpenMat73(const std::filesystem::path& path);

}  // namespace fathom
