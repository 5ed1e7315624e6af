// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/sources/dof_of_log.h"

#include <string>
#include <vector>

#include "error_from.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

Log LogAbout(const std::string& path, std::vector<Dof> dofs) {
  Log log;
  log.path = path;
  log.dofs = std::move(dofs);
  return log;
}

std::string RefusalOfDof(std::vector<Log> logs) {
  return ErrorFrom([&] { DofOfAll(logs, {}); });
}

TEST(DofOfAll, IsTheGivenOneOrTheOnlyOne) {
  const std::vector<Log> logs = {LogAbout("a", {Dof::kHeave})};
  EXPECT_EQ(DofOfAll(logs, Dof::kYaw), Dof::kYaw);
  EXPECT_EQ(DofOfAll(logs, {}), Dof::kHeave);
  EXPECT_EQ(RefusalOfDof({LogAbout("b", {Dof::kHeave, Dof::kYaw})}),
            "--dof: is missing, and b/log.yaml names 2 DOFs; say which.");
}

TEST(DofOfAll, IsTheOneThatAllLogsName) {
  const std::vector<Log> logs = {LogAbout("a", {Dof::kHeave}), LogAbout("b", {Dof::kHeave})};
  EXPECT_EQ(DofOfAll(logs, {}), Dof::kHeave);
  EXPECT_EQ(RefusalOfDof({LogAbout("a", {Dof::kHeave}), LogAbout("b", {Dof::kYaw})}),
            "--dof: is missing, and a/log.yaml names heave, but b/log.yaml yaw; say which.");
  EXPECT_EQ(RefusalOfDof({LogAbout("a", {})}),
            "--dof: is missing, and a/log.yaml names 0 DOFs; say which.");
}

}  // namespace
}  // namespace fathom
