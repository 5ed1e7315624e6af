// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/pid.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

namespace fathom {

Pid::Pid(const PidGains& gains, double period) : gains_(gains), period_(period) {
  CHECK_GT(gains.limit, 0.0);
  CHECK_GT(period, 0.0);
}

double Pid::Force(double setpoint, double position) {
  const double error = setpoint - position;
  if (is_first_) last_error_ = error;
  const double slope = (error - last_error_) / period_;
  const double integral = is_first_ ? 0.0 : integral_ + 0.5 * (error + last_error_) * period_;
  const double wanted = gains_.kp * error + gains_.ki * integral + gains_.kd * slope;
  const bool winds_up = std::abs(wanted) > gains_.limit && wanted * error > 0.0;
  if (!winds_up) integral_ = integral;
  last_error_ = error;
  is_first_ = false;
  const double force = gains_.kp * error + gains_.ki * integral_ + gains_.kd * slope;
  return std::clamp(force, -gains_.limit, gains_.limit);
}

}  // namespace fathom
