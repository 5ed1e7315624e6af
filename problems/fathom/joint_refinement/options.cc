// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/options.h"

#include <fmt/format.h>

namespace fathom {

std::vector<std::string> JointOptions::Problems() const {
  std::vector<std::string> problems;
  const auto require_positive = [&](const char* name, double value) {
    if (!(value > 0.0)) {
      problems.push_back(fmt::format("{} is {}, expected a value above 0", name, value));
    }
  };
  const auto require_not_negative = [&](const char* name, double value) {
    if (!(value >= 0.0)) {
      problems.push_back(fmt::format("{} is {}, expected 0 or more", name, value));
    }
  };
  require_positive("loss_limit", loss_limit);
  require_positive("max_iterations", max_iterations);
  require_positive("max_rounds", max_rounds);
  require_not_negative("clock_offset_std", clock_offset_std);
  require_not_negative("size_scale_std", size_scale_std);
  require_not_negative("mount_position_std", mount_position_std);
  require_not_negative("mount_angle_std", mount_angle_std);
  if (initial_guess) require_positive("initial_guess.inertia", initial_guess->inertia);
  if (moves_freely && clock_offset_std > 0.0) {
    problems.push_back("clock_offset_std is above 0, expected 0 where the DOF moves freely");
  }
  return problems;
}

}  // namespace fathom
