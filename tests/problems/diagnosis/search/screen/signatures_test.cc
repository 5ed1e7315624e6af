// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/signatures.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <memory>
#include <string>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

struct SmallEffect {
  const char* name;
  std::vector<double> values;
  int amount;
};

void PrintTo(const SmallEffect& effect, std::ostream* out) { *out << effect.name; }

class Signatures : public testing::TestWithParam<SmallEffect> {
 protected:
  Signatures() {
    SurgeRun run;
    run.input = Multisine(40.0);
    run.duration = 90.0;
    run.has_poses = true;
    const std::vector<Log> logs = {LogOf(run, 1)};
    data_ = std::make_unique<TrainingData>(MeasuredSegmentsOf(logs, Dof::kSurge).all);
    fit_.model = {kSurgeTruth, {}};
    fit_.initial = {{0.05, 0.0}};
  }

  // Against a simulation with the effect, less one without.
  void ExpectThatOfTheSimulation(const SmallEffect& small) const {
    const std::vector<Suspect> suspects = {{FindEffect(small.name), {}}};
    Trial trial;
    trial.values = small.values;
    trial.amounts = {small.amount};
    const ForceResponse response(data_.get(), fit_);
    const Eigen::VectorXd signature =
        SignaturesOf(*data_, response, fit_, suspects, std::vector{trial}).col(0);
    const auto with = data_->Simulate(
        WithEffect(fit_.model, {FindEffect(small.name), {}, small.values}), fit_.initial);
    const Eigen::VectorXd expected = *with - *data_->Simulate(fit_.model, fit_.initial);
    ASSERT_GT(expected.norm(), 0.0);
    // Within a step of 0.1 s a force counts as even.
    EXPECT_LT((signature - expected).norm(), 0.03 * expected.norm());
  }

  std::unique_ptr<TrainingData> data_;
  StructureFit fit_;
};

TEST_P(Signatures, AreThoseOfTheSimulation) { ExpectThatOfTheSimulation(GetParam()); }

TEST_P(Signatures, BesideALagAreThoseOfTheSimulation) {
  fit_.model = WithEffect(fit_.model, {FindEffect("thruster_lag"), {}, {0.4}});
  if (std::string(GetParam().name) != "thruster_lag") ExpectThatOfTheSimulation(GetParam());
}

// Small, so that the simulation's answer is nearly that of the linearised model.
INSTANTIATE_TEST_SUITE_P(OfThrustersAndPoses,
                         Signatures,
                         testing::Values(SmallEffect{"thrust_step_loss", {0.02, 40.0}, 0},
                                         SmallEffect{"thrust_asymmetry", {0.02}, 0},
                                         SmallEffect{"time_offset", {0.02}, 0},
                                         SmallEffect{"thruster_lag", {0.02}, 0},
                                         SmallEffect{"marker_moved", {0.1, 40.0}, 0},
                                         SmallEffect{"pose_scale", {0.02}, 0},
                                         SmallEffect{"sensor_lag", {0.05}, 0}));

}  // namespace
}  // namespace fathom
