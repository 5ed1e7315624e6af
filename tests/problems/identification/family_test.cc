// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/family.h"

#include "fathom/base/input_error.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Family, NamesGoThereAndBack) {
  std::set<std::string> names;
  for (const Family family : kAllFamilies) {
    names.emplace(Name(family));
    EXPECT_EQ(ParseFamily(std::string(Name(family))), family);
  }
  EXPECT_EQ(names, (std::set<std::string>{"least_squares", "adaptive", "output_error", "joint"}));
}

TEST(Family, AnUnknownNameIsRefusedWithTheNamesThereAre) {
  for (const std::string name : {"kalman", "", "Adaptive", "adaptive "}) {
    try {
      ParseFamily(name);
      ADD_FAILURE() << "'" << name << "' is taken for a family";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(),
                  AllOf(HasSubstr("'" + name + "'"),
                        HasSubstr("one of least_squares, adaptive, output_error, joint.")));
    }
  }
}

TEST(Family, TheJointRefinementTakesNoSignals) {
  EXPECT_EQ(ParseSignalFamily("adaptive"), Family::kAdaptive);
  try {
    ParseSignalFamily("joint");
    ADD_FAILURE() << "joint is taken for a family of signals";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("one of least_squares, adaptive, output_error."));
  }
}

}  // namespace
}  // namespace fathom
