// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/weighting.h"

#include "fathom/base/input_error.h"

namespace fathom {

std::string_view Name(Weighting weighting) {
  switch (weighting) {
    case Weighting::kPlain:
      return "plain";
    case Weighting::kLearned:
      return "learned";
    case Weighting::kAuto:
      break;
  }
  return "auto";
}

Weighting ParseWeighting(const std::string& name) {
  for (const Weighting weighting : {Weighting::kAuto, Weighting::kPlain, Weighting::kLearned}) {
    if (Name(weighting) == name) return weighting;
  }
  throw InputError("is '" + name + "', expected one of auto, plain, learned.");
}

}  // namespace fathom
