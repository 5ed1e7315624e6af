// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// How output error weighs what the simulation misses, docs/output_error.md (10).
enum class Weighting {
  kPlain,    // all samples alike, but for outliers
  kLearned,  // by sensor noise and disturbance, learned from the residual
};

// "plain", "learned".
std::string_view Name(Weighting weighting);

// Throws InputError, listing the names, in the form of ParseDof().
Weighting ParseWeighting(const std::string& name);

}  // namespace fathom
