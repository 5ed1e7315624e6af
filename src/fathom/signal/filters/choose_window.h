// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

namespace fathom {

// How noisy values at these stamps are best smoothed: the shortest window [s] whose prediction of
// left-out samples is within 1 % of the best, by mean absolute error, among windows from
// `shortest` upwards in steps of sqrt(2) to `longest`. A sample is left out together with its
// neighbours within a quarter of the shortest window, lest noise that they share looks like
// motion; docs/signal.md (4).
double ChooseWindow(std::span<const double> time,
                    std::span<const double> values,
                    int order,
                    double shortest,
                    double longest);

}  // namespace fathom
