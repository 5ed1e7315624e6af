// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/ordinary_knowledge.h"

#include "fathom/base/interval95.h"
#include "fathom/planning/information.h"

#include <cmath>

namespace fathom {

OrdinaryKnowledge KnowledgeBy(const Eigen::MatrixXd& information,
                              const std::vector<OrdinaryParameter>& parameters) {
  const Eigen::MatrixXd covariance = InverseOf(information);
  OrdinaryKnowledge knowledge;
  knowledge.share = 0.0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto place = static_cast<Eigen::Index>(i);
    const double std = std::sqrt(covariance(place, place));
    knowledge.stds.push_back(std);
    const double share = kStdsOf95 * std / parameters[i].size;
    if (!(share > knowledge.share)) continue;
    knowledge.share = share;
    knowledge.weakest = i;
  }
  return knowledge;
}

}  // namespace fathom
