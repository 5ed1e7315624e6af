// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

namespace fathom {

// Inertia of data/vehicles/flatfish.yaml in surge [kg].
inline constexpr double kSurgeInertia = 851.05;

// Makes a log of a minute of surge before a wall of data/films, the last 12 s held out: corners of
// the markers, true poses in pose.csv, a velocity sensor of 1 cm/s. `amplitude` of the force [N].
std::filesystem::path SynthesizeMinute(const std::filesystem::path& log,
                                       const std::string& film,
                                       double amplitude,
                                       int seed);

}  // namespace fathom
