// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/store/compared_dofs.h"

#include <string>

#include <gtest/gtest.h>

namespace fathom {
namespace {

void AddFits(int num_dives, const std::string& dofs, std::vector<DiveFitRow>* rows) {
  for (int dive = 0; dive < num_dives; ++dive) {
    DiveFitRow row;
    row.dive = std::to_string(dive);
    row.dof = dofs;
    row.vehicle = "rov";
    row.usable = true;
    row.value = 1.0;
    rows->push_back(row);
  }
}

TEST(CoupledDofsCompared, NeedsFiveDivesAndThreeQuartersOfAll) {
  const auto compared = [](int num_alone, int num_coupled) {
    std::vector<DiveFitRow> rows;
    AddFits(num_alone, "surge", &rows);
    AddFits(num_coupled, "surge,yaw", &rows);
    return CoupledDofsCompared(rows, "rov");
  };
  EXPECT_EQ(compared(6, 5), "surge,yaw");
  EXPECT_EQ(compared(7, 5), "");
  EXPECT_EQ(compared(4, 4), "");
  EXPECT_EQ(compared(12, 9), "surge,yaw");
  EXPECT_EQ(compared(12, 8), "");
}

TEST(CoupledDofsCompared, AreThoseOfMostDives) {
  std::vector<DiveFitRow> rows;
  AddFits(6, "surge,sway,yaw", &rows);
  AddFits(7, "surge,yaw", &rows);
  EXPECT_EQ(CoupledDofsCompared(rows, "rov"), "surge,yaw");
  EXPECT_EQ(CoupledDofsCompared(rows, "auv"), "");
  for (DiveFitRow& row : rows) row.usable = false;
  EXPECT_EQ(CoupledDofsCompared(rows, "rov"), "");
}

TEST(CoupledDofsCompared, StandForTheirDofsAndNoOther) {
  EXPECT_TRUE(AreCompared("surge,yaw", "surge,yaw"));
  EXPECT_FALSE(AreCompared("surge", "surge,yaw"));
  EXPECT_FALSE(AreCompared("yaw", "surge,yaw"));
  EXPECT_TRUE(AreCompared("sway", "surge,yaw"));
  EXPECT_FALSE(AreCompared("surge,sway,yaw", "surge,yaw"));
  EXPECT_TRUE(AreCompared("surge", ""));
  EXPECT_FALSE(AreCompared("surge,yaw", ""));
}

}  // namespace
}  // namespace fathom
