// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/start_price.h"

#include <algorithm>
#include <cmath>

namespace fathom {

std::vector<double> StartGainsOf(const TrainingData& data,
                                 const ExtendedModel& model,
                                 std::span<const InitialState> initial,
                                 const Eigen::VectorXd& variance) {
  std::vector<double> gains;
  const std::vector<Excess> excesses = EffectSimulation::ExcessesOf(model);
  int next = EffectSimulation::NumParameters(model);
  for (const InitialState& state : initial) {
    next += data.num_states(model);
    int i = next - static_cast<int>(excesses.size());
    for (const Excess excess : excesses) {
      const double value = state.*excess;
      gains.push_back(variance[i] > 0.0 ? value * value / variance[i] : 0.0);
      ++i;
    }
  }
  return gains;
}

double PriceOfStarts(const TrainingData& data, std::span<const double> start_gains) {
  const double most = std::log(static_cast<double>(data.bins().size()));
  double price = 0.0;
  for (const double gain : start_gains) price += std::min(gain, most);
  return price;
}

}  // namespace fathom
