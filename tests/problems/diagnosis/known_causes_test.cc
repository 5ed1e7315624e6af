// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What docs/diagnosis_dead_zone.md and docs/diagnosis_lag.md claim, over several seeds: the
// baseline is wrong, the extended model is right, and the cause is named.

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/synthesize/experiment/experiment_file.h"
#include "fathom/synthesize/synthesize.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <array>
#include <cmath>
#include <span>
#include <string>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr double kInertiaOfFlatfish = 851.05, kLinearDampingOfFlatfish = 39.57;

// FlatFish under an experiment of data/experiments with one effect hidden, diagnosed.
Diagnosis DiagnosedFlatfish(const std::string& name,
                            const std::string& effect,
                            double value,
                            int seed) {
  const std::filesystem::path data = FATHOM_DATA_DIR;
  const Vehicle vehicle = ReadVehicleFile(data / "vehicles/flatfish.yaml");
  const Experiment experiment = ReadExperimentFile(data / "experiments" / name);
  const ActiveEffect hidden = {FindEffect(effect), {.dof = Dof::kSurge}, {value}};
  const Log log = Synthesize(
      vehicle, experiment, std::span<const ActiveEffect>(&hidden, 1), static_cast<unsigned>(seed));
  return Diagnose(std::span<const Log>(&log, 1), Dof::kSurge);
}

// The cause of this effect, alone or in a group with it; null if there is none.
const Cause* FindCause(const Diagnosis& diagnosis, const std::string& effect) {
  for (const Cause& cause : diagnosis.causes) {
    const ActiveEffect& active = diagnosis.extended.model.effects[cause.effect_index];
    if (active.effect->info().name == effect) return &cause;
    for (const Alternative& other : cause.alternatives) {
      if (other.label == effect) return &cause;
    }
  }
  return nullptr;
}

// No cause but `cause` is named for certain.
void ExpectNoOtherCertainCause(const Diagnosis& diagnosis, const Cause* cause) {
  for (const Cause& other : diagnosis.causes) {
    if (&other == cause) continue;
    EXPECT_FALSE(other.alternatives.empty())
        << diagnosis.extended.model.effects[other.effect_index].effect->info().name;
  }
}

// Of the first parameter of a cause.
double StdOf(const Diagnosis& diagnosis, const Cause& cause) {
  std::size_t index = kNumParameters;
  for (int k = 0; k < cause.effect_index; ++k) {
    index += diagnosis.extended.model.effects[k].values.size();
  }
  return std::sqrt(diagnosis.extended.covariance.diagonal()[static_cast<Eigen::Index>(index)]);
}

class KnownCauses : public ::testing::TestWithParam<int> {};

TEST_P(KnownCauses, ADeadZoneOfEightNewtonIsNamedAndTheInertiaPutRight) {
  const Diagnosis diagnosis =
      DiagnosedFlatfish("surge_multisine.yaml", "thrust_dead_zone", 8.0, GetParam());
  EXPECT_GT(diagnosis.baseline.model.baseline.inertia, 1.15 * kInertiaOfFlatfish);
  EXPECT_NEAR(
      diagnosis.extended.model.baseline.inertia, kInertiaOfFlatfish, 0.02 * kInertiaOfFlatfish);
  const Cause* cause = FindCause(diagnosis, "thrust_dead_zone");
  ASSERT_NE(cause, nullptr);
  EXPECT_THAT(cause->alternatives, IsEmpty());
  ExpectNoOtherCertainCause(diagnosis, cause);
  const double width = diagnosis.extended.model.effects[cause->effect_index].values[0];
  const double std = StdOf(diagnosis, *cause);
  EXPECT_NEAR(width, 8.0, 4.0 * std);
  EXPECT_LT(std, 0.4);
  EXPECT_LT(diagnosis.extended.held_out.nmae, diagnosis.baseline.held_out.nmae);
}

// In the linear range lags commute: which of the two it is no such log can tell.
TEST_P(KnownCauses, ALagOfHalfASecondIsNamedAndTheLinearDampingPutRight) {
  const Diagnosis diagnosis = DiagnosedFlatfish("surge_fast.yaml", "thruster_lag", 0.5, GetParam());
  EXPECT_GT(std::abs(diagnosis.baseline.model.baseline.linear_damping - kLinearDampingOfFlatfish),
            0.5 * kLinearDampingOfFlatfish);
  EXPECT_NEAR(diagnosis.extended.model.baseline.linear_damping,
              kLinearDampingOfFlatfish,
              0.05 * kLinearDampingOfFlatfish);
  const Cause* cause = FindCause(diagnosis, "thruster_lag");
  ASSERT_NE(cause, nullptr);
  ASSERT_EQ(cause->alternatives.size(), 1u);
  const ActiveEffect& active = diagnosis.extended.model.effects[cause->effect_index];
  EXPECT_THAT((std::array{std::string(active.effect->info().name), cause->alternatives[0].label}),
              UnorderedElementsAre("sensor_lag", "thruster_lag"));
  EXPECT_EQ(diagnosis.verdict, Verdict::kAmbiguous);
  EXPECT_FALSE(cause->experiment.text.empty());
  ExpectNoOtherCertainCause(diagnosis, cause);
  const double std = StdOf(diagnosis, *cause);
  EXPECT_NEAR(active.values[0], 0.5, 4.0 * std);
  EXPECT_LT(std, 0.02);
  EXPECT_LT(diagnosis.extended.held_out.nmae, 0.5 * diagnosis.baseline.held_out.nmae);
}

INSTANTIATE_TEST_SUITE_P(Seeds, KnownCauses, ::testing::Range(1, 7));

// Positions have white noise, and turbulence moves the vehicle: that noise has two maxima of
// likelihood, and the step from one to the other is no cause. A rate of 5 % would leave seven or
// eight of eight.
TEST(PilotInTurbulence, NeedsNoCause) {
  const std::filesystem::path data = FATHOM_DATA_DIR;
  const Vehicle vehicle = ReadVehicleFile(data / "vehicles/flatfish.yaml");
  const Experiment experiment = ReadExperimentFile(data / "experiments/pilot.yaml");
  int num_consistent = 0;
  for (unsigned seed = 20; seed < 28; ++seed) {
    const Log log = Synthesize(vehicle, experiment, {}, seed);
    const Diagnosis diagnosis = Diagnose(std::span<const Log>(&log, 1), Dof::kSurge);
    EXPECT_THAT(diagnosis.causes, IsEmpty()) << seed;
    num_consistent += diagnosis.verdict == Verdict::kConsistent ? 1 : 0;
  }
  EXPECT_GE(num_consistent, 7);
}

}  // namespace
}  // namespace fathom
