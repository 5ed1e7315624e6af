// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <optional>
#include <vector>

namespace fathom {

enum class InputKind { kSine, kMultisine, kSteps };
enum class WanderKind {
  kFiltered,   // white noise through two lags
  kSinusoids,  // a dozen slow sines of random phase
  kRough,      // Ornstein-Uhlenbeck: no velocity at all
  kBand,       // normal noise, flat from 0.01 to 0.25 Hz and nothing beyond
  kCycle,      // hunts about its setpoint: a triangle of some 10 s, its period drifting
  kSteps,      // goes to another level every 20 s or so
  kNone
};

// A run of data/vehicles/flatfish.yaml along one DOF before a wall of markers, down to the corners
// that a detector would report. The vehicle is integrated by a code of its own; the corners are
// those of the true poses plus noise.
struct CameraExperiment {
  Dof dof = Dof::kSurge;
  InputKind input = InputKind::kSine;
  int num_markers = 1;        // 1 or 4
  double duration = 300.0;    // [s]
  double rate = 10.0;         // of frames and commands [Hz]
  double corner_noise = 0.3;  // [px]
  WanderKind wander = WanderKind::kFiltered;
  double wander_position = 0.01;        // std of each held coordinate [m]
  double wander_angle = 0.002;          // [rad]
  double pitch_per_acceleration = 0.0;  // pitch follows the excited DOF's acceleration [rad s^2/m]
  // As a pendulum of this frequency [rad/s] and damping ratio; 0: at once.
  double pitch_frequency = 0.0, pitch_damping = 1.0;
  double disturbance = 0.0;   // std of a random force on the excited DOF, slow by 2 s [N] or [N m]
  double outliers = 0.0;      // share of detections whose corners are somewhere else
  double flips = 0.0;         // share of frames whose first guess is the square's other solution
  double clock_offset = 0.0;  // what the camera's stamps lack [s]
  double size_scale = 1.0;    // true side of the markers over that of the map
  // Where the camera truly hangs less where its mount says, along the body's axes [m].
  std::array<double, 3> mount_error = {};
  double distance = 3.3;         // of the markers from the camera [m]
  double marker_side = 0.4;      // [m]
  double focal_length = 1400.0;  // [px]
  // Another vehicle, which the multisine moves in open loop along its DOF; absent: FlatFish.
  std::optional<UncoupledModel<double>> vehicle = {};
  unsigned seed = 1;
};

struct SyntheticCameraRun {
  JointInput input;  // first guesses: each frame's own least-squares pose
  UncoupledModel<double> truth;
  std::vector<double> true_velocity;
  std::vector<double> true_displacement;
  std::vector<Pose> true_world_from_body;
};

UncoupledModel<double> FlatFish(Dof dof);

SyntheticCameraRun Synthesize(const CameraExperiment& experiment);

// The input with the segments that the tools make of its detections: by TrackMarkers(), as
// PrepareMarkerLogs() does.
JointInput Tracked(const SyntheticCameraRun& run);

// A small vehicle that goes to and fro before a marker far away, which it sees face on: both poses
// of the square fit in most frames, and neither is the right one.
CameraExperiment BeforeADistantMarker(double duration, unsigned seed);

// The run's first guesses as the poses of a log, for what works on poses.
Log PoseLog(const SyntheticCameraRun& run);

}  // namespace fathom
