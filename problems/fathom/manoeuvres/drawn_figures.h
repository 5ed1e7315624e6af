// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/manoeuvre_figures.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace fathom {

using ManoeuvreFigures = std::optional<std::vector<ManoeuvreFigure>>;

// `count` models from the covariance, in an order that `seed` determines. Where the model knows
// offsets of single runs, each is of another run, whose offset scatters as those do.
std::vector<CoupledModel> DrawModels(const FittedCoupledModel& fitted,
                                     int count,
                                     std::uint64_t seed);

inline constexpr double kEnoughDraws = 0.8;  // of all, for an interval

struct FigureInterval {
  double low = 0.0, high = 0.0;  // 95 %; NaN where fewer than kEnoughDraws came so far
};

// The intervals of the figures that drawn models give, one for each of `num_figures`. Draws without
// figures count as draws that did not come so far.
std::vector<FigureInterval> IntervalsOf(const std::vector<ManoeuvreFigures>& drawn,
                                        std::size_t num_figures);

}  // namespace fathom
