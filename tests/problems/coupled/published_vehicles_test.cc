// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The bundled coupled vehicles are found again from logs that fathom_synthesize makes of them.

#include "fathom/coupled/block_fit.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/synthesize/experiment/experiment_file.h"
#include "fathom/synthesize/synthesize.h"

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

struct PublishedVehicle {
  std::string vehicle;
  std::string experiment;
  StandardStructure structure;
};

void PrintTo(const PublishedVehicle& published, std::ostream* out) { *out << published.vehicle; }

class PublishedVehicles : public ::testing::TestWithParam<PublishedVehicle> {};

// Of 80 of the experiment's 300 seconds. Errors of the inertia: 2 % of it along the axes, 10 % of
// sqrt(M_ii M_jj) off the diagonal.
TEST_P(PublishedVehicles, AreFoundAgain) {
  const std::string data = FATHOM_DATA_DIR;
  const Vehicle vehicle = ReadVehicleFile(data + "/vehicles/" + GetParam().vehicle + ".yaml");
  Experiment experiment =
      ReadExperimentFile(data + "/experiments/" + GetParam().experiment + ".yaml");
  experiment.duration = 80.0;
  experiment.held_out.clear();
  const CoupledModel& truth = *vehicle.coupled;
  CoupledLogs logs;
  logs.data = {CoupledDataOf(
      Synthesize(vehicle, experiment, 1), truth.dofs, vehicle.thrusters, vehicle.fins)};
  std::vector<StructureFin> fins;
  for (const Fin& fin : vehicle.fins) fins.push_back({fin.name, false, false});
  CoupledFitOptions options;
  options.body = vehicle.body;
  const CoupledSummary fit =
      FitBlocks(logs, StructureOf(GetParam().structure, truth.dofs, fins), options);
  ASSERT_TRUE(fit.IsUsable()) << fit.message;
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(fit.model.inertia(i, i) / truth.inertia(i, i), 1.0, 0.02) << i;
    for (int j = 0; j < i; ++j) {
      const double size = std::sqrt(truth.inertia(i, i) * truth.inertia(j, j));
      EXPECT_NEAR(fit.model.inertia(i, j) / size, truth.inertia(i, j) / size, 0.1) << i << ' ' << j;
    }
  }
  for (const auto& [fin, force] : truth.fin_force) {
    EXPECT_NEAR(fit.model.fin_force.at(fin) / force, 1.0, 0.05) << fin;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Bundled,
    PublishedVehicles,
    ::testing::Values(
        PublishedVehicle{"bluerov2", "random_steps_rov", StandardStructure::kSymmetric},
        PublishedVehicle{"remus100", "random_steps_auv", StandardStructure::kSymmetric},
        PublishedVehicle{"rexrov", "random_steps_work_class", StandardStructure::kLopsided}),
    [](const auto& info) { return info.param.vehicle; });

}  // namespace
}  // namespace fathom
