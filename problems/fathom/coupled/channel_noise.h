// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_summary.h"
#include "fathom/coupled/fitted_channel.h"
#include "fathom/coupled/window_problem.h"
#include "fathom/coupled/window_residuals.h"

#include <vector>

// What the residuals of each channel look like. Vectors over channels are in the problem's order.

namespace fathom {

// The standard deviation of the white noise that a sensor has at the least [unit of the channel].
// Of data of a simulation without noise only rounding and integration are left, and would pass for
// structure.
std::vector<double> QuietestSensors(const WindowProblem& problem);

// White noise of the residuals' robust spread, no quieter than `quietest` [unit of the channel].
std::vector<ChannelNoise> WhiteNoiseOf(const std::vector<WindowResiduals>& residuals,
                                       const std::vector<FittedChannel>& channels,
                                       const std::vector<double>& quietest);

// Coloured noise; white where the residuals are quieter than `quietest` [unit of the channel]. Wild
// ones are cut to five standard deviations before their colour is learned.
std::vector<ChannelNoise> ColouredNoiseOf(const std::vector<WindowResiduals>& residuals,
                                          const std::vector<FittedChannel>& channels,
                                          const std::vector<double>& quietest);

// Whether a noise is one of these channels, in their order.
bool IsOf(const std::vector<ChannelNoise>& noise, const std::vector<FittedChannel>& channels);

// How the residuals of such a noise are weighed. `huber_k`: from how many standard deviations on
// one counts linearly.
std::vector<ChannelWeight> WeightsOf(const std::vector<ChannelNoise>& noise, double huber_k);

}  // namespace fathom
