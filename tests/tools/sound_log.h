// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <vector>

namespace fathom {

// A surge run as numbers, to be made wrong on purpose, and written.
struct LogNumbers {
  std::vector<double> command_time, force;  // [s], [N]
  std::vector<double> time, speed;          // [s], [m/s]
  double mass = 0.0;                        // [kg], as log.yaml says

  // Command in thruster_1 and thruster_2 rather than tau_surge: their speeds are this many times
  // those in Hz. 0: forces.
  double thruster_speed_unit = 0.0;
};

// Two and a half minutes of a vehicle of 22.5 kg that moves with 38 kg, at 10 Hz: a multisine of 15
// N rms, speeds to about 1 m/s, noise of 0.01 m/s. Nothing is wrong with it.
LogNumbers SoundLog(const std::filesystem::path& scratch);

// The same vehicle under a twentieth of that force: speeds to about 0.1 m/s, noise of 0.001 m/s.
LogNumbers SlowSoundLog(const std::filesystem::path& scratch);

// log.yaml, command.csv, velocity.csv, and a vehicle file where the command is of thrusters, in
// `folder`, which is given back.
std::filesystem::path Write(const LogNumbers& log, const std::filesystem::path& folder);

}  // namespace fathom
