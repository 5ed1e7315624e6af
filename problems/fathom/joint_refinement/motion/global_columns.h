// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/parameters.h"

#include <array>

namespace fathom {

// The unknowns that every frame of a segment depends on, side by side as columns:
//
//   model     log inertia, quadratic damping, linear damping, buoyancy   shared by all segments
//   size      scale of every marker's side                               shared
//   mount     small move of body_from_camera: translation [m] in the body frame, rotation vector
//             [rad] in the camera's                                      shared
//   start     velocity and position at the segment's first frame         of the segment
//   response  of each held coordinate: its mean, and what it does per unit of the excited DOF's
//             scaled displacement, velocity and acceleration, and of the latter behind each of
//             kResponseLags                                              of the segment
//   clock     what is to be added to the camera's stamps [s]             of the segment
inline constexpr int kModelColumns = kNumParameters;
inline constexpr int kSizeColumn = kModelColumns;
inline constexpr int kMountColumns = kSizeColumn + 1;
inline constexpr int kNumShared = kMountColumns + 6;
inline constexpr int kSetupColumns = kNumShared - kSizeColumn;  // size and mount

inline constexpr int kNumHeld = 5;  // coordinates that are not excited
// Time constants that a response may have [s]: a geometric row over what vehicles show. What lies
// between is a mixture of two, and so is, nearly, a pendulum that does not swing.
inline constexpr std::array<double, 3> kResponseLags = {0.5, 1.2, 3.0};
inline constexpr int kNumRegressors = 3 + static_cast<int>(kResponseLags.size());
inline constexpr int kResponseTerms = 1 + kNumRegressors;
inline constexpr int kNumResponse = kNumHeld * kResponseTerms;
inline constexpr int kStartColumns = kNumShared;
inline constexpr int kResponseColumns = kStartColumns + 2;
inline constexpr int kClockColumn = kResponseColumns + kNumResponse;
inline constexpr int kNumColumns = kClockColumn + 1;

}  // namespace fathom
