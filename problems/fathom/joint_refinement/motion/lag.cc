// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/motion/lag.h"

#include <cmath>

namespace fathom {

SignalRows Lagged(std::span<const double> time, double time_constant, const SignalRows& signals) {
  SignalRows lagged(signals.rows(), signals.cols());
  if (signals.rows() > 0) lagged.row(0) = signals.row(0);
  for (Eigen::Index k = 1; k < signals.rows(); ++k) {
    const double steps = (time[k] - time[k - 1]) / time_constant;
    const double decay = std::exp(-steps), mean = -std::expm1(-steps) / steps;
    lagged.row(k) = decay * lagged.row(k - 1) + (mean - decay) * signals.row(k - 1) +
                    (1.0 - mean) * signals.row(k);
  }
  return lagged;
}

}  // namespace fathom
