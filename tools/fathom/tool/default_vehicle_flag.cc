// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/default_vehicle_flag.h"

#include "fathom/vehicle/files/vehicle_file.h"

#include <gflags/gflags.h>

DEFINE_string(default_vehicle, "", "Vehicle file (YAML) of logs whose log.yaml names no vehicle.");

namespace fathom {

std::filesystem::path DefaultVehicleFromFlag() {
  if (!FLAGS_default_vehicle.empty()) ReadVehicleFile(FLAGS_default_vehicle);
  return FLAGS_default_vehicle;
}

}  // namespace fathom
