// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/structure_ladder.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <cmath>
#include <random>

#include "drawn_vehicle.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// 100 s of a drawn vehicle whose thrust lags 0.1 to 1 s, or whose command's clock is as much ahead.
class LateVehicle : public testing::TestWithParam<unsigned> {
 protected:
  LateVehicle() : random_(3000 + GetParam()), vehicle_(DrawnPlanarVehicle(&random_)) {
    late_ = std::uniform_real_distribution<double>(0.1, 1.0)(random_);
    options_.duration = 100.0;
  }

  // That the ladder names this and nothing else, and 3.3 standard deviations hold the truth: all
  // 8 vehicles do in 99 of 100 suites.
  void ExpectNamed(const CoupledData& data, const FreeEntry& entry) const {
    CoupledLogs logs;
    logs.data = {data};
    const Ladder ladder = ClimbLadder(logs, vehicle_.dofs, {});
    ASSERT_EQ(ladder.named.size(), 1u);
    EXPECT_EQ(NameOf(ladder.named[0].entry), NameOf(entry));
    EXPECT_LT(std::abs(ladder.named[0].value - late_), 3.3 * ladder.named[0].std);
    EXPECT_LT(ladder.named[0].std, 0.02);
  }

  std::mt19937 random_;
  CoupledModel vehicle_;
  DrawnLogOptions options_;
  double late_ = 0.0;  // [s]
};

TEST_P(LateVehicle, HasALagThatIsNamed) {
  CoupledModel lagging = vehicle_;
  lagging.thruster_lag = late_;
  ExpectNamed(DrawnLog(lagging, options_, &random_), ThrusterLagEntry());
}

TEST_P(LateVehicle, HasAnOffsetThatIsNamed) {
  CoupledData data = DrawnLog(vehicle_, options_, &random_);
  for (double& t : data.inputs.command.time) t -= late_;
  ExpectNamed(data, TimeOffsetEntry());
}

INSTANTIATE_TEST_SUITE_P(Seeds, LateVehicle, testing::Range(1u, 5u));

}  // namespace
}  // namespace fathom
