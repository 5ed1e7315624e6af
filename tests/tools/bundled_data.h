// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

inline const std::string kData = FATHOM_DATA_DIR;
inline const std::string kFlatfish = kData + "/flatfish";
inline const std::string kFilms = kData + "/films/";

}  // namespace fathom
