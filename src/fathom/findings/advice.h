// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"

#include <string>
#include <string_view>

namespace fathom {

// What a finding does to a model, and how to mend it.
struct Advice {
  std::string_view effect;
  std::string_view remedy;
};

// Of a finding's code; empty for a code without advice.
Advice AdviceOn(std::string_view code);

// How to mend a finding: the remedy of its code, with its own column in place of COLUMN.
std::string RemedyOf(const Finding& finding);

}  // namespace fathom
