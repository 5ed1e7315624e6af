// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/figure.h"

#include "fathom/base/input_error.h"

namespace fathom {

void WriteFigure(const TimePanel&, const std::filesystem::path& path) {
  throw InputError(path.string() + ": figures are not drawn yet.");
}

void WriteFigure(const std::vector<ParameterPanel>&, const std::filesystem::path& path) {
  throw InputError(path.string() + ": figures are not drawn yet.");
}

}  // namespace fathom
