// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/command_clock.h"
#include "fathom/findings/finding.h"
#include "fathom/log/log.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// By how much the camera is later than velocity.csv.
struct CameraDelay {
  double delay = 0.0;     // [s]; negative: it is earlier
  double evidence = 0.0;  // how many times more likely than none, as a natural logarithm
};

// The clock of the camera against that of velocity.csv, up to 10 s either way: the two velocities
// along all DOFs that move (twin_motion.h) are one motion, delayed by
//
//   argmin_d  sum_a N/2 log(1 - r_a(d)^2)                                   docs/findings.md (9)
//
//   r_a  their correlation along DOF a at delay d; 0 where it is negative
//   N    seconds that both cover: as long as both are smoothed
//
// in steps of 0.05 s. Nothing unless one correlation is then 0.8 or more, the delay is e^10 times
// as likely as none, and no other one is as good, as it is of a periodic motion. In these two
// comparisons 1 - r^2 counts as 0.02 at least: noise and the steps blur it.
std::optional<CameraDelay> FindCameraDelay(const Log& log);

// What FindCameraDelay() compares: r_a over the delay, one curve for each DOF that moves.
struct CameraDelayCurve {
  std::string column;  // of velocity.csv
  DelayCurve curve;
};
std::vector<CameraDelayCurve> CameraDelayCurves(const Log& log);

// As a finding `camera_delay` of over 0.1 s and one sample; over a second it is a warning.
std::optional<Finding> CheckCameraClock(const Log& log, const CameraDelay& found);

}  // namespace fathom
