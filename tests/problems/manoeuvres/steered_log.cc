// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "steered_log.h"

#include <cmath>
#include <fstream>

#include "test_folder.h"

namespace fathom {

Log SteeredLog(const std::string& size) {
  Log log;
  log.path = TestFolder();
  log.dofs = {Dof::kYaw};
  log.vehicle = "boat.yaml";
  std::ofstream(log.path / log.vehicle) << "name: boat\n"
                                        << size << "fins:\n  - {name: rudder, position: ["
                                        << kAftOfSteeredLog << ", 0, 0], axis: [0, 0, 1]}\n";
  for (int k = 0; k < 50; ++k) {
    const double t = 0.1 * k;
    if (k == 0) {
      log.command = Stream{.time = {}, .columns = {"tau_surge", "tau_yaw"}, .values = {{}, {}}};
      log.fins = Stream{.time = {}, .columns = {"fin_rudder"}, .values = {{}}};
      log.velocity = Stream{.time = {}, .columns = {"u", "r"}, .values = {{}, {}}};
    }
    log.command->time.push_back(t);
    log.command->values[0].push_back(5.0);
    log.command->values[1].push_back(0.0);
    log.fins->time.push_back(t);
    log.fins->values[0].push_back(0.1 * std::sin(t));
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back(kAheadOfSteeredLog);
    log.velocity->values[1].push_back(0.02 * std::sin(t));
  }
  return log;
}

}  // namespace fathom
