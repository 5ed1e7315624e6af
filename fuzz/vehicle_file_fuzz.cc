// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a vehicle file; what is read must then turn thruster speeds into finite forces.

#include "fathom/base/input_error.h"
#include "fathom/vehicle/files/thruster_command.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto vehicle =
        fathom::ParseVehicleFile("v.yaml", std::string(reinterpret_cast<const char*>(data), size));
    fathom::Stream command;
    command.time = {0.0, 1.0};
    for (std::size_t i = 1; i <= vehicle.thrusters.size(); ++i) {
      command.columns.push_back("thruster_" + std::to_string(i));
      command.values.push_back({10.0, -3.0});
    }
    fathom::ForcesOfThrusts(fathom::ThrustsFromSpeeds(command, vehicle), vehicle);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
