// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/store/tables.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fathom {

// The joint model of one dive.
struct FittedDive {
  std::string vehicle;
  int place = 0;      // of the dive in the order of all dives
  std::string dofs;   // one, or several of a coupled model: "surge,yaw"
  std::string model;  // a model file's text
};

// Adds what changed over the dives of each vehicle, and why, and which dives are outliers:
// docs/archive_trends.md. Which fits count is what CoupledDofsCompared() says of tables->dive_fits.
// `vehicle_files`: by the vehicle's name, empty where it has none;
// thrusters are named by them.
void AddChangesOfDives(const std::vector<FittedDive>& fits,
                       const std::vector<std::string>& dives,
                       const std::map<std::string, std::filesystem::path>& vehicle_files,
                       Tables* tables);

}  // namespace fathom
