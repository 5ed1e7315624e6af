// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/names_of_dofs.h"

#include <cstddef>

namespace fathom {

std::string NamesOf(const std::vector<Dof>& dofs) {
  std::string names;
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    if (i > 0) names += i + 1 == dofs.size() ? " and " : ", ";
    names += Name(dofs[i]);
  }
  return names;
}

}  // namespace fathom
