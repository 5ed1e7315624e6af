// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/files/vehicle_file.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fathom {

// The vehicle of METHODS.md: like FlatFish along surge.
inline constexpr UncoupledModel<double> kSurgeTruth = {890.0, 60.0, 39.0, -0.8};

// A run along surge with something hidden in it.
struct SurgeRun {
  UncoupledModel<double> model = kSurgeTruth;
  InputSignal input;
  double duration = 120.0;  // [s]
  double rate = 10.0;       // [Hz], of command and sensors
  bool has_velocity = true;
  double velocity_noise = 0.01;    // [m/s]
  double noise_correlation = 0.0;  // from one sample to the next
  bool has_poses = false;
  double position_noise = 0.01;    // [m]
  double turbulence = 0.0;         // RMS of a random force that decays within 3 s [N]
  std::string effects;             // as --effects; none: nothing hidden
  std::vector<ActiveEffect> more;  // effects that have no name in the catalogue
  std::string name = "run";
};

// Twelve lines from 0.06 to 1.6 rad/s.
InputSignal Multisine(double rms);
InputSignal Sine(double amplitude, double frequency);
InputSignal Square(double amplitude, double period);
InputSignal Steps(std::vector<double> levels, double hold);

Log LogOf(const SurgeRun& run, std::uint64_t seed);

// The log without what its sensors showed from `from` up to `to`, as if they had been switched off.
Log WithoutMotion(Log log, double from, double to);

}  // namespace fathom
