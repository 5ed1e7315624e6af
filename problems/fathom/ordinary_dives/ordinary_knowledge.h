// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A parameter, and how well all logs know it.
struct OrdinaryParameter {
  std::string name;  // as in files
  std::string unit;
  double value = std::numeric_limits<double>::quiet_NaN();

  // What intervals are compared with: the value; of the buoyancy the greatest force; of a damping
  // at least a hundredth of what would take the greatest force at the greatest speed, so that one
  // of 0 has a size too.
  double size = std::numeric_limits<double>::quiet_NaN();

  double by_all = std::numeric_limits<double>::infinity();   // standard deviation by all logs
  double by_fit = std::numeric_limits<double>::quiet_NaN();  // as the model's file has it
};

// Standard deviations of the parameters in their order; infinite: nothing is known.
struct OrdinaryKnowledge {
  std::vector<double> stds;
  std::size_t weakest = 0;                                 // of the widest interval by size
  double share = std::numeric_limits<double>::infinity();  // half of that interval by size
};

// By information in the order of the parameters.
OrdinaryKnowledge KnowledgeBy(const Eigen::MatrixXd& information,
                              const std::vector<OrdinaryParameter>& parameters);

}  // namespace fathom
