// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <string>

namespace fathom {

// How LimitTable() is to be read. Where a row rules out no effect too, what that means, and why the
// effect is not named all the same.
std::string HowToReadLimits(const Diagnosis& diagnosis);

}  // namespace fathom
