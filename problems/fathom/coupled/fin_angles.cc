// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/fin_angles.h"

#include <algorithm>
#include <limits>

namespace fathom {
namespace {

// Where a fin stands that turns towards an angle for a while.
double Turned(double from, double towards, double most) {
  return std::clamp(towards, from - most, from + most);
}

}  // namespace

FinAngles::FinAngles(const CoupledCommand& command, const CoupledModel& model)
    : command_(command),
      rates_(command.fins.size(), std::numeric_limits<double>::infinity()),
      begun_(command.fins.size()) {
  for (std::size_t k = 0; k < command.fins.size(); ++k) {
    const CommandedFin& fin = command.fins[k];
    const auto limit = model.fin_rate_limit.find(fin.name);
    if (limit == model.fin_rate_limit.end()) continue;
    rates_[k] = limit->second;
    double angle = 0.0;
    for (std::size_t row = 0; row < command.time.size(); ++row) {
      begun_[k].push_back(angle);
      if (row + 1 == command.time.size()) break;
      angle =
          Turned(angle, fin.angle[row], rates_[k] * (command.time[row + 1] - command.time[row]));
    }
  }
}

double FinAngles::At(std::size_t fin, std::size_t row, double since) const {
  const double commanded = command_.fins[fin].angle[row];
  return begun_[fin].empty() ? commanded : Turned(begun_[fin][row], commanded, rates_[fin] * since);
}

}  // namespace fathom
