// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/coupled/six_vector.h"
#include "fathom/vehicle/fin.h"
#include "fathom/vehicle/shaft.h"
#include "fathom/vehicle/thruster.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fathom {

// One unbroken stretch of a log's motion. Both streams keep their own stamps.
struct CoupledSegment {
  std::vector<double> time;       // of the velocities [s], strictly increasing
  std::vector<Vector6> velocity;  // as measured, or from the poses; NaN where neither tells

  std::vector<double> pose_time;                  // [s], strictly increasing; may be empty
  std::vector<Eigen::Quaterniond> attitude = {};  // world_from_body, or empty
  std::vector<Eigen::Vector3d> position = {};     // world [m]; NaN along axes that are not known

  bool is_held_out = false;
};

// A log as a model of several DOFs takes it.
struct CoupledData {
  std::string log;  // its name
  std::vector<Dof> dofs;
  CoupledInputs inputs;
  std::vector<CoupledSegment> segments;

  std::array<bool, 6> has_velocity = {};  // a column of velocity.csv; else poses tell it
  bool has_attitude = false;
  std::array<bool, 3> has_position = {};  // x, y, z

  std::string force_unit;            // "N", or the log's command_unit
  std::vector<std::string> remarks;  // what was left out, a sentence each
};

// `thrusters`: of the vehicle, in the order of the log's; where the log holds none they say
// nothing. `fins` and `shafts`: of the vehicle; those that the log holds act. DOFs beside `dofs`
// move as they were measured, where they were. A log without any motion is one segment, at the
// command's stamps, of which nothing is known.
//
// Throws InputError if the log measures motion but not that of one of the DOFs, commands none of
// them, or holds a fin or a shaft that the vehicle has not.
CoupledData CoupledDataOf(const Log& log,
                          const std::vector<Dof>& dofs,
                          std::span<const Thruster> thrusters = {},
                          std::span<const Fin> fins = {},
                          std::span<const Shaft> shafts = {});

// The state that was measured at a sample of a segment: velocities by a straight line through the
// samples within half a second, unknown ones 0; the attitude level where none is known.
CoupledState MeasuredState(const CoupledSegment& segment, std::size_t sample);

// Samples `begin` to `end` - 1 of a segment, about `length` [s] each, equally long; the whole
// segment where that is shorter than one and a half. Together they hold every sample, each two at
// least.
struct SampleWindow {
  std::size_t begin = 0;
  std::size_t end = 0;
};
std::vector<SampleWindow> WindowsOf(const CoupledSegment& segment, double length);

}  // namespace fathom
