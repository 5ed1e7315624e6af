// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log.h"

#include <algorithm>

namespace fathom {

const std::vector<double>* Stream::Find(std::string_view column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  return found == columns.end() ? nullptr : &values[found - columns.begin()];
}

}  // namespace fathom
