// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/simulate/log_prediction.h"

#include <optional>

namespace fathom {

// A model against a log that it was not fitted to: do the fluctuations v of the measured speed
// follow those of the predicted one, p? Both are about their means, which buoyancy and a current
// shift.
//
//   slope   sum(p v) / sum(p^2)                                            docs/findings.md (3)
//   share   (sum (v - p)^2 - n s^2) / (sum v^2 - n s^2)                    docs/findings.md (4)
//
//   s   standard deviation of the sensor's noise, by second differences    [m/s] or [rad/s]
//   n   samples
//
// A warning of code "prediction" if the slope lies outside 2/3 to 3/2 or the share above 1/2, each
// by over three standard errors. Noise of the sensor moves neither. Also if there is no prediction,
// because it diverges: no vehicle does, under commands that it was given. Nothing where no motion
// was measured.
std::optional<Finding> CheckPrediction(const std::optional<LogPrediction>& prediction, Dof dof);

}  // namespace fathom
