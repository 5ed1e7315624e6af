// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/coupled_dives.h"

#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;

// Five dives of a log each. All show a coupling, one a number that no other shows, and each the
// current of its own log.
TEST(CoupledDiveTasks, FreeWhatDivesShareAndTheCurrentOfEach) {
  std::vector<BatchLog> logs;
  std::map<std::string, int> place;
  for (int k = 0; k < 5; ++k) {
    BatchLog& log = logs.emplace_back();
    log.vehicle = "boat";
    log.dive = fmt::format("day_{}", k);
    log.is_done = true;
    log.coupled = {.dofs = "surge,sway,yaw",
                   .coriolis = true,
                   .beyond_diagonal = {"inertia.sway.yaw", fmt::format("current.north.run_{}", k)}};
    if (k == 0) log.coupled->beyond_diagonal.emplace_back("coulomb_friction.surge");
    place[log.dive] = k;
  }
  const auto tasks = CoupledDiveTasks(logs, place);
  ASSERT_EQ(tasks.size(), 5u);
  for (const auto& [key, task] : tasks) {
    EXPECT_THAT(
        task.free,
        ElementsAre("inertia.sway.yaw", fmt::format("current.north.run_{}", std::get<int>(key))));
  }
}

}  // namespace
}  // namespace fathom
