// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// Probability that chi-square with `freedom` degrees of freedom, an integer from 0 on, reaches
// `value`.
double ChiSquareTail(double value, int freedom);

}  // namespace fathom
