// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/follower_file.h"

#include <cmath>
#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

const AdaptiveOptions kWritten = {.gains = AdaptiveGains{-0.1, {1.1e-5, 20.0, 0.7, 0.015}}};

AdaptiveFollower FollowerBehind(int num) {
  AdaptiveFollower follower(kWritten);
  for (int i = 0; i < num; ++i) {
    follower.Add(0.1 * i, 30.0 * std::sin(0.03 * i), 0.2 * std::sin(0.03 * i - 0.7));
  }
  return follower;
}

std::string With(const std::string& key, const std::string& value) {
  std::string text = FormatFollower(Dof::kSurge, kWritten, FollowerBehind(5));
  const auto begin = text.find("\"" + key + "\":") + key.size() + 3;
  return text.replace(begin, text.find_first_of(",}", begin) - begin, value);
}

std::string ProblemOf(const std::string& text,
                      Dof dof = Dof::kSurge,
                      const AdaptiveOptions& options = kWritten) {
  return ErrorFrom([&] { ParseFollower("s.json", text, dof, options); });
}

TEST(FollowerFile, GoesOnToTheLastDigit) {
  AdaptiveFollower whole = FollowerBehind(1300);
  AdaptiveFollower again =
      ParseFollower("s.json", FormatFollower(Dof::kYaw, kWritten, whole), Dof::kYaw, kWritten);
  for (int i = 1300; i < 1500; ++i) {
    const auto a = whole.Add(0.1 * i, 10.0, 0.01 * (i % 7)),
               b = again.Add(0.1 * i, 10.0, 0.01 * (i % 7));
    ASSERT_EQ(ToVector(a.model), ToVector(b.model)) << i;
    ASSERT_EQ(a.std, b.std) << i;
  }
}

TEST(FollowerFile, RefusesAnotherDofAndOtherOptions) {
  const std::string text = FormatFollower(Dof::kSurge, kWritten, FollowerBehind(5));
  EXPECT_EQ(ProblemOf(text), "no error");
  EXPECT_EQ(ProblemOf(text, Dof::kSway), "s.json: 'dof' is surge, expected sway as --dof says.");
  AdaptiveOptions other = kWritten;
  other.integrator = AdaptiveIntegrator::kEuler;
  EXPECT_EQ(ProblemOf(text, Dof::kSurge, other),
            "s.json: 'integrator' is runge_kutta, expected euler as --integrator says.");
  other = kWritten;
  other.gains->lambda[1] = 21.0;
  EXPECT_EQ(ProblemOf(text, Dof::kSurge, other),
            "s.json: 'gains' is -0.1,1.1e-05,20,0.7,0.015, expected -0.1,1.1e-05,21,0.7,0.015 as "
            "--gains says.");
}

TEST(FollowerFile, RefusesWhatIsNoState) {
  EXPECT_EQ(ProblemOf("t,tau,v\n"),
            "s.json: is no state of a stream, expected the JSON of fathom_follow --state.");
  EXPECT_THAT(ProblemOf("{"), HasSubstr("s.json: is not JSON"));
  EXPECT_THAT(ProblemOf("{}"), HasSubstr("s.json: 'schema' is missing"));
  EXPECT_THAT(ProblemOf(With("schema", "\"fathom-model-1\"")),
              HasSubstr("s.json: 'schema' is no fathom-follow-1"));
  EXPECT_THAT(ProblemOf(With("t", "null")), HasSubstr("s.json: 't' is "));
  EXPECT_THAT(ProblemOf(With("num_samples", "4.5")),
              HasSubstr("s.json: 'num_samples' is 4.5, expected a whole number from 1 on"));
  EXPECT_THAT(ProblemOf(With("num_samples", "6")),
              HasSubstr("s.json: 'scatter.blocks' counts 5 samples in all, expected 6"));
  EXPECT_THAT(ProblemOf(With("block_size", "0")), HasSubstr("s.json: 'scatter.block_size' is 0"));
}

}  // namespace
}  // namespace fathom
