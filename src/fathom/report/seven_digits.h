// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// The number as a page carries it: rounded to seven digits. NaN and infinity stay what they are.
double ToSevenDigits(double value);

}  // namespace fathom
