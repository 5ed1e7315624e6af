// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_fit.h"
#include "fathom/coupled_planning/coupled_plan_files.h"
#include "fathom/coupled_planning/coupled_plan_text.h"
#include "fathom/coupled_planning/plan_coupled.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boat_trial.h"
#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

// Noise whose neighbours correlate by 0.8. What fits miss of the truth: coupled_noise_table.
TEST(PlanCoupledNoise, IntervalsUnderColouredNoiseAreThoseOfTheNextFits) {
  const double colour = 0.8;
  const DrawnBoat boat = DrawBoat(22, colour);
  const CoupledPlanRequest request = BoatRequest(boat, 30.0, 0.1);
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  EXPECT_EQ(plan.noise_source[0], NoiseSource::kLog);
  std::vector<double> ratios;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const std::vector<CoupledData> next = {
        PlayedLog(boat.truth, plan.command, plan.duration, kBoatNoise, seed, colour)};
    const CoupledSummary fit =
        FitCoupled(next, StructureOf(StandardStructure::kCoriolis, boat.truth.dofs));
    ASSERT_TRUE(fit.IsUsable()) << fit.message;
    ASSERT_EQ(fit.entries, boat.fitted.entries);
    for (std::size_t k = 0; k < fit.entries.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      ratios.push_back(std::sqrt(fit.covariance(at, at)) / plan.parameters[k].after);
    }
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_NEAR(ratios[ratios.size() / 2], 1.0, 0.2);
}

// A file of before the colour was written down.
TEST(PlanCoupledNoise, SaysThatItTakesNoiseAsWhiteWhoseColourIsNotKnown) {
  CoupledPlanRequest request = BoatRequest(DrawBoat(21, 0.8), 20.0, 0.1);
  request.model.residual_autoregression = {};
  request.limits.noise[5] = 0.02;
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  EXPECT_THAT(
      CoupledPlanComments(request, plan),
      Contains(AllOf(HasSubstr("Of yaw it is white, as large as the limits file says."),
                     HasSubstr("Of surge, sway it is taken as white, as large as the log shows: "
                               "boat.json does not hold its colour."))));
  const std::string json = FormatCoupledPlan(request, plan);
  EXPECT_THAT(json, HasSubstr("\"surge\": \"log_taken_as_white\""));
  EXPECT_THAT(json, HasSubstr("\"yaw\": \"limits\""));
}

TEST(PlanCoupledNoise, RefusesAColourThatDoesNotDieAway) {
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  request.model.residual_autoregression[1] = {1.5};
  EXPECT_EQ(ErrorFrom([&] { PlanCoupledExperiment(request); }),
            "boat.json: of sway, 'fit.residual_autoregression' is not stable, expected "
            "coefficients of noise that dies away.");
}

}  // namespace
}  // namespace fathom
