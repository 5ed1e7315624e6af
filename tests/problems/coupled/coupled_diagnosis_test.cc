// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_diagnosis.h"

#include "fathom/synthesize/experiment/experiment_file.h"
#include "fathom/synthesize/synthesize.h"

#include <string>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::IsEmpty;

constexpr auto kRoll = static_cast<std::size_t>(Index(Dof::kRoll));

// 100 s of the BlueROV2 that tumbles under random steps, fitted with all of its inertia.
CoupledIdentification TumblingRov() {
  const std::string data = FATHOM_DATA_DIR;
  const Vehicle vehicle = ReadVehicleFile(data + "/vehicles/bluerov2.yaml");
  Experiment experiment = ReadExperimentFile(data + "/experiments/random_steps_rov.yaml");
  experiment.duration = 100.0;
  experiment.held_out.clear();
  CoupledIdentificationOptions options;
  options.dofs = vehicle.coupled->dofs;
  options.structure = StandardStructure::kSymmetric;
  CoupledIdentification identified = IdentifyCoupled({Synthesize(vehicle, experiment, 1)}, options);
  identified.ladder.emplace();  // that names nothing
  return identified;
}

// It is unstable: from a straight line through the samples its run is far off after 20 s.
TEST(CoupledDiagnosis, BlamesNoModelForHowTheStartWasMeasured) {
  const CoupledIdentification identified = TumblingRov();
  ASSERT_TRUE(identified.is_usable) << identified.message;
  const CoupledDiagnosis diagnosis = DiagnoseCoupled(identified, {});
  EXPECT_THAT(diagnosis.missed, IsEmpty());
}

// The same runs of a model that damps roll a tenth more.
TEST(CoupledDiagnosis, SaysWhatRunsOfTheFitMiss) {
  CoupledIdentification identified = TumblingRov();
  ASSERT_TRUE(identified.is_usable) << identified.message;
  identified.fitted.model.quadratic_damping(Index(Dof::kRoll), Index(Dof::kRoll)) *= 1.1;
  identified.prediction =
      *PredictCoupled(identified.fitted.model, identified.data, identified.fit_options.window);
  const CoupledDiagnosis diagnosis = DiagnoseCoupled(identified, {});
  EXPECT_THAT(diagnosis.missed, ::testing::Contains(Dof::kRoll));
}

}  // namespace
}  // namespace fathom
