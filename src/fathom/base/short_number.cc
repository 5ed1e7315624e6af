// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/short_number.h"

#include <fmt/format.h>

namespace fathom {

std::string ShortNumber(double value, int digits) {
  return fmt::format("{}", std::stod(fmt::format("{:.{}g}", value, digits)));
}

}  // namespace fathom
