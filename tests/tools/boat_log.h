// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace fathom {

// A boat with a thruster `port` and one `starboard`, 0.3 m from its middle.
struct Boat {
  double starboard_gain = 1.0;  // what the starboard thruster gives of its command
  bool turns = true;            // false: both thrusters are commanded alike
  unsigned seed = 5;            // of the commands and the noise
  bool rolls = false;           // true: its roll swings, which nothing commands, by 0.1 rad/s
  bool names_vehicle = true;    // false: log.yaml names no vehicle file, and none is beside it
};

// A log of surge and yaw in `folder`, which is given back: 80 s at 20 Hz, of thrusts that step
// every 3 s. Inertia 40 kg and 5 kg m^2. Integrated without C(nu), by Euler in steps of 1 ms.
std::filesystem::path WriteBoatLog(const Boat& boat, const std::filesystem::path& folder);

// The vehicle file of the boat.
void WriteBoatFile(const std::filesystem::path& file);

}  // namespace fathom
