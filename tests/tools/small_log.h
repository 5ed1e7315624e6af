// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

namespace fathom {

// One minute of a surge run at 10 Hz under a square wave of two amplitudes, without noise: 601 rows
// in each file, stamped 0.0, 0.1, ... 60.0; inertia 40 kg, quadratic damping 30 kg/m, linear
// damping 5 kg/s, buoyancy 1 N.
std::string SmallCommandCsv();   // t,tau_surge
std::string SmallVelocityCsv();  // t,u
std::string SmallSingleCsv();    // t,tau,v

// log.yaml, command.csv and velocity.csv in `folder`, which is given back.
std::filesystem::path WriteSmallLog(const std::filesystem::path& folder);

// The same where nothing was commanded and nothing moved, for 30 s.
std::filesystem::path WriteStillLog(const std::filesystem::path& folder);

// A model file of that vehicle's surge, written by hand.
std::string SmallModelJson();

// A vehicle file of it.
std::string SmallVehicleYaml();

}  // namespace fathom
