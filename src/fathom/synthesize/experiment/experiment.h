// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/synthesize/experiment/input_signal.h"
#include "fathom/synthesize/experiment/pid.h"
#include "fathom/synthesize/experiment/turbulence.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Bursts in which a sensor says nothing.
struct DropOuts {
  double probability = 0.0;  // that one starts at a sample, in [0, 1)
  double shortest = 0.0;     // [s], above 0
  double longest = 0.0;      // [s], at least shortest; lengths are uniform in between
};

// When a sensor measures. The stamps in the log are the true times of measuring.
struct Sampling {
  double rate = 10.0;   // [Hz], above 0
  double jitter = 0.0;  // standard deviation about the even grid [s]; at most 0.4 of a period
  DropOuts drop_outs;
};

struct VelocitySensor {
  Sampling sampling;
  std::vector<Dof> dofs = {};     // that it logs; empty: the driven ones, or all of a coupled model
  std::array<double, 6> noise{};  // standard deviation, by Index(Dof) [m/s] or [rad/s]
  double noise_correlation = 0.0;        // from one sample to the next, in [0, 1); 0: white
  double outlier_probability = 0.0;      // that a sample is one, in [0, 1]
  std::array<double, 6> outlier_size{};  // standard deviation of what is then added
  double resolution = 0.0;               // values are rounded to multiples of it; 0: not rounded
};

struct PoseSensor {
  Sampling sampling;
  double position_noise = 0.0;       // standard deviation along each world axis [m]
  double angle_noise = 0.0;          // standard deviation about each body axis [rad]
  double outlier_probability = 0.0;  // that a sample is one, in [0, 1]
  double outlier_position = 0.0;     // standard deviation of what is then added, as above [m]
  double outlier_angle = 0.0;        // [rad]
  double resolution = 0.0;           // as above
  bool is_logged = true;             // false: only the controllers see it
};

// How one DOF is driven.
struct Drive {
  Dof dof = Dof::kSurge;
  InputSignal input;  // a force, or a position in the world if there is a PID
  std::optional<PidGains> pid;
  double initial_speed = 0.0;  // [m/s] or [rad/s]
  TurbulenceSpec turbulence = {};
};

// How one thruster, fin or shaft is driven.
struct ActuatorDrive {
  std::string name;   // as in the vehicle file
  InputSignal input;  // a thrust [N], an angle [rad], or turns [Hz]
};

// What is done with a vehicle and how it is measured; docs/file_formats.md. The vehicle starts with
// its body frame in the world frame.
struct Experiment {
  std::string name;
  std::string notes;
  double start_time = 0.0;          // log time of the start [s]
  double duration = 0.0;            // [s], above 0
  double command_rate = 10.0;       // [Hz], of the command and the controllers, above 0
  double command_resolution = 0.0;  // forces are rounded to multiples of it; 0: not rounded
  std::vector<Drive> drives;        // in the order of Dof; at least one of these and the next three
  std::vector<ActuatorDrive> thrusters = {};          // of a coupled vehicle, in place of drives
  std::vector<ActuatorDrive> fins = {};               // of a coupled vehicle, beside either
  std::vector<ActuatorDrive> shafts = {};             // likewise
  Eigen::Vector2d current = Eigen::Vector2d::Zero();  // of a coupled vehicle: north, east [m/s]
  std::optional<VelocitySensor> velocity;
  std::optional<PoseSensor> pose;
  std::vector<TimeInterval> held_out;  // log time [s]
};

}  // namespace fathom
