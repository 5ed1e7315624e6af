// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/event_fit.h"
#include "fathom/trends/pattern.h"

#include <limits>

#include <Eigen/Core>

namespace fathom {

// One cause fitted to one event.
struct PatternFit {
  double misfit = std::numeric_limits<double>::infinity();  // chi-square
  double p_value = 0.0;                                     // of the misfit
  double score = std::numeric_limits<double>::infinity();   // misfit and the price of what is free
  double factor = 0.0;                                      // f, of a pattern that has one
  double factor_std = 0.0;
  Eigen::VectorXd sizes;  // z
  Eigen::VectorXd size_std;
  bool has_right_sign = false;
};

// Of the series that show the event only. `price` is that of a free number.
PatternFit FitPattern(const Pattern& pattern, const EventFit& event, double price);

}  // namespace fathom
