// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/matlab/matlab_file.h"

#include <cstdint>
#include <string_view>

namespace fathom {

// Types of the elements of a .mat of version 5.
inline constexpr std::uint32_t kMat5Matrix = 14;
inline constexpr std::uint32_t kMat5Compressed = 15;

// Lists the arrays of a variable: of an element kMat5Matrix with its tag. `variable`: where it is
// in the file. Throws InputError, telling the byte of the variable, where the element is damaged;
// what lies before is listed.
void ListMat5Arrays(std::string_view bytes,
                    MatlabByteOrder order,
                    std::uint64_t variable,
                    MatlabListing* listing);

}  // namespace fathom
