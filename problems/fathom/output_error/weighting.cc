// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/weighting.h"

#include "fathom/base/input_error.h"

namespace fathom {

std::string_view Name(Weighting weighting) {
  return weighting == Weighting::kPlain ? "plain" : "learned";
}

Weighting ParseWeighting(const std::string& name) {
  for (const Weighting weighting : {Weighting::kPlain, Weighting::kLearned}) {
    if (Name(weighting) == name) return weighting;
  }
  throw InputError("is '" + name + "', expected one of plain, learned.");
}

}  // namespace fathom
