// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/joint_identification.h"

#include <vector>

#include "handmade_identification.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

constexpr Source kSensor = Source::kPoseEstimator, kCamera = Source::kCamera;

Identification RowWith(Family family, double inertia, double train_nmae, double held_out_nmae) {
  Identification row = HandmadeRow(family, train_nmae, held_out_nmae);
  row.fitted.model.inertia = inertia;
  return row;
}

class OrBestGuessOf : public ::testing::Test {
 protected:
  const std::vector<Identification> guesses_ = {RowWith(Family::kLeastSquares, 41.0, 0.20, 0.30),
                                                UnusableRow(Family::kAdaptive),
                                                RowWith(Family::kOutputError, 42.0, 0.25, 0.20)};
};

TEST_F(OrBestGuessOf, AGoodRefinementIsThatRefinement) {
  const auto row = OrBestGuess(RowWith(Family::kJoint, 43.0, 0.9, 0.203), guesses_, kSensor);
  EXPECT_EQ(row.fitted.model.inertia, 43.0);
  EXPECT_EQ(row.message, "converged");
  EXPECT_TRUE(row.fitted.caveats.empty());
}

TEST_F(OrBestGuessOf, ARefinementThatFailedIsTheBestGuess) {
  const auto row = OrBestGuess(UnusableRow(Family::kJoint), guesses_, kSensor);
  EXPECT_TRUE(row.is_usable);
  EXPECT_EQ(row.family, Family::kJoint);
  EXPECT_EQ(row.fitted.model.inertia, 42.0);
  EXPECT_EQ(row.message,
            "The joint refinement has no usable model: the command never changes This is the model "
            "of the initial guess by output_error on the poses.");
  EXPECT_EQ(row.fitted.caveats.front(), row.message);
  EXPECT_EQ(row.stand_in, Family::kOutputError);
}

TEST_F(OrBestGuessOf, ARefinementThatIsWorseOnHeldOutDataIsTheBestGuess) {
  const auto row = OrBestGuess(RowWith(Family::kJoint, 43.0, 0.1, 0.205), guesses_, kSensor);
  EXPECT_EQ(row.fitted.model.inertia, 42.0);
  EXPECT_THAT(row.message, HasSubstr("simulates worse (NMAE 0.205)"));
}

// A sensor that no row was fitted to is as good as held-out data; the derivative of the very poses
// that the guesses were fitted to is not.
TEST_F(OrBestGuessOf, ARunWithoutHeldOutDataIsJudgedByASensorAlone) {
  std::vector<Identification> guesses = guesses_;
  for (Identification& guess : guesses) guess.fitted.held_out = {};
  Identification joint = RowWith(Family::kJoint, 43.0, 0.22, 0.0);
  joint.fitted.held_out = {};
  EXPECT_EQ(OrBestGuess(joint, guesses, kSensor).fitted.model.inertia, 41.0);
  EXPECT_EQ(OrBestGuess(joint, guesses, kCamera).fitted.model.inertia, 43.0);
}

TEST_F(OrBestGuessOf, NothingUsableIsNothing) {
  const std::vector<Identification> none = {UnusableRow(Family::kOutputError)};
  EXPECT_FALSE(OrBestGuess(UnusableRow(Family::kJoint), none, kSensor).is_usable);
}

}  // namespace
}  // namespace fathom
