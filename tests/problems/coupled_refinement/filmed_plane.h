// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/geometry/stamped_pose.h"
#include "fathom/joint_refinement/logs/marker_logs.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <cstdint>
#include <string>

namespace fathom {

// A log of data/vehicles/planar_rov.yaml, whose surge, sway and yaw move together, as a camera sees
// it before four markers: data/experiments/film_planar.yaml, shorter.
struct FilmedPlane {
  MarkerLogs logs;
  Stream truth;  // where the camera's vehicle was, as pose.csv: with how the held DOFs moved
  CoupledModel model;
};

struct FilmedPlaneOptions {
  double duration = 60.0;                           // [s], the last ten held out
  double corner_sigma = 0.3;                        // [px]
  double hold_position = 0.01, hold_angle = 0.005;  // of the DOFs that are not driven [m], [rad]
  std::uint64_t seed = 1;
};

FilmedPlane FilmPlane(const FilmedPlaneOptions& options);

}  // namespace fathom
