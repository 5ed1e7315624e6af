// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/family.h"

#include <set>
#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

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
    EXPECT_THAT(ErrorFrom([&] { ParseFamily(name); }),
                AllOf(HasSubstr("'" + name + "'"),
                      HasSubstr("one of least_squares, adaptive, output_error, joint.")));
  }
}

TEST(Family, TheJointRefinementTakesNoSignals) {
  EXPECT_EQ(ParseSignalFamily("adaptive"), Family::kAdaptive);
  EXPECT_THAT(ErrorFrom([&] { ParseSignalFamily("joint"); }),
              HasSubstr("one of least_squares, adaptive, output_error."));
}

}  // namespace
}  // namespace fathom
