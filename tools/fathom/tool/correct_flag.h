// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/correction.h"

#include <vector>

namespace fathom {

// What --correct asks for, "p:-1" or "p:-1,u:0.5"; nothing if it is not given. Throws InputError
// for anything else.
std::vector<Correction> CorrectionsFromFlag();

}  // namespace fathom
