// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// Whether a residual of several segments is white as far as means tell, docs/output_error.md (12).
// For K = 2, 4, 8, ..., as long as there are 32 means of K neighbours: their variance, K times, is
// at most two standard deviations above the variance of the samples. Of n normal and white samples
// the ratio of the two, with n / K means, has the variance 2 K / n - 2 / n. `is_wild`: samples left
// out. A residual that is white is called coloured in up to one in six cases, the longer the
// oftener.
bool IsWhite(const std::vector<std::vector<double>>& residuals);

}  // namespace fathom
