// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/search_result.h"

#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// One cause at some values, all of them held on a bound or none.
Hypothesis With(std::string_view name, std::vector<double> values, bool is_on_bound) {
  Hypothesis hypothesis;
  hypothesis.fit.is_on_bound.assign(kNumParameters, false);
  hypothesis.fit.is_on_bound.resize(kNumParameters + values.size(), is_on_bound);
  hypothesis.fit.model.effects.push_back({FindEffect(name), {}, std::move(values)});
  return hypothesis;
}

TEST(IsPhysical, UnlessAnAmountPressesOnItsBound) {
  EXPECT_TRUE(IsPhysical(With("thrust_asymmetry", {0.3}, false)));
  EXPECT_FALSE(IsPhysical(With("thrust_asymmetry", {0.98}, true)));
}

TEST(IsPhysical, WhereAnAmountIsHeldAtNone) {
  EXPECT_TRUE(IsPhysical(With("thrust_dead_zone", {0.0}, true)));
}

// A memory longer than the log, say: that there is one shows all the same.
TEST(IsPhysical, WhereOnlyAShapeIsOnItsBound) {
  Hypothesis hypothesis = With("fluid_memory", {5.0, 100.0}, false);
  hypothesis.fit.is_on_bound.back() = true;
  EXPECT_TRUE(IsPhysical(hypothesis));
}

TEST(IsPhysical, WithoutACauseWhateverTheBaselineDoes) {
  Hypothesis hypothesis;
  hypothesis.fit.is_on_bound.assign(kNumParameters, true);
  EXPECT_TRUE(IsPhysical(hypothesis));
}

}  // namespace
}  // namespace fathom
