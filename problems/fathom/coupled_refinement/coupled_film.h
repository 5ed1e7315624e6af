// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"
#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/motion_structure.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A stretch of a log as the camera saw it, which is simulated from a start of its own.
struct FilmWindow {
  std::shared_ptr<const CoupledInputs> inputs;     // of its log; DOFs not modelled hold still
  std::vector<double> time;                        // of the frames [s], strictly increasing
  std::vector<std::vector<Detection>> detections;  // of each frame, at least one
  std::vector<Pose> world_from_body;               // of each frame, a first guess by PnP
  CoupledState start;                              // a first guess, at the first frame; held
                                                   // angles as they are in the mean of its segment
  std::size_t segment = 0;                         // the unbroken stretch that it is a part of
};

// One or several logs of one vehicle, several of whose DOFs move together.
struct CoupledFilm {
  CameraModel camera;
  MarkerMap map;  // all markers surveyed
  Pose body_from_camera;
  MotionStructure structure;
  RigidBody body;  // what keeps the inertia physical: docs/coupled.md (7)
  std::vector<FilmWindow> windows;
};

// The angles of roll and pitch that are not modelled. A vehicle that surges moves along its own
// axis, and its trim tells which way that is: one number each, for all windows.
std::vector<int> TrimRows(const MotionStructure& structure);

// The unknowns of a window. The pose of frame k is the simulated one, then the deviation: along the
// body's axes [m] and about them [rad], by Index(Dof).
struct FilmWindowUnknowns {
  // A step from FilmWindow::start: velocities of the modelled DOFs, turns about the body's axes of
  // the modelled angles [rad], the position [m].
  std::vector<double> start;
  std::vector<std::array<double, 6>> deviation = {};
  std::vector<std::array<double, 6>> rate = {};  // d deviation / dt
};

// All unknowns of the joint problem of a coupled model.
struct FilmUnknowns {
  CoupledModel model;  // what is not free stays as it is here

  // What all windows share: the entries of CoupledFilm::structure, in its order, then turns of all
  // starts about the axes of TrimRows() [rad].
  std::vector<double> shared;
  std::vector<FilmWindowUnknowns> windows;

  // The model with the entries in it.
  CoupledModel Model(const MotionStructure& structure) const;
};

// Unknowns at a model: no window is moved from its start, and no pose from the simulated one.
FilmUnknowns FilmUnknownsAt(const CoupledFilm& film, const CoupledModel& model);

}  // namespace fathom
