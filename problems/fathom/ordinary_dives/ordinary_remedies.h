// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/ordinary_dives/ordinary_dives.h"
#include "fathom/ordinary_dives/run_noise.h"
#include "fathom/ordinary_dives/run_normal.h"
#include "fathom/planning/segment_derivatives.h"

#include <vector>

#include <Eigen/Core>

namespace fathom {

// What ordinary dives reach, outliers left out.
struct OrdinaryReach {
  double force = 0.0;  // greatest, either way, in the command's unit
  double speed = 0.0;  // [m/s] or [rad/s]
};

// What remedies are forecast from; all outlive the call.
struct RemedyTask {
  const OrdinaryRequest& request;
  const OrdinaryDives& dives;               // parameters, all, rate
  const std::vector<Eigen::Index>& places;  // of the parameters in the covariance
  const OrdinaryReach& reach;
  const RunNoise& noise;
  const RunNormal& of_all;              // of all logs
  const std::vector<SegmentRun>& runs;  // over all segments
};

// What would make the weakest parameter by all logs better known, best first. Only what can
// be forecast: no positions where the fit is made to them already; neither these nor a faster rate
// where neighbouring samples err alike, since what the model lacks shows in both.
std::vector<Remedy> RemediesFor(const RemedyTask& task);

}  // namespace fathom
