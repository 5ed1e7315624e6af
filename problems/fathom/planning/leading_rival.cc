// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/leading_rival.h"

#include "fathom/planning/information.h"

#include <algorithm>

namespace fathom {

std::optional<PlanRequest> LedByRival(PlanRequest request,
                                      std::size_t index,
                                      const RunSetting& log) {
  if (index == 0) return request;
  const auto leader = request.rivals.begin() + static_cast<std::ptrdiff_t>(index);
  MotionDerivatives derivatives;
  if (!MotionUnder(leader->model, log.dof, log.command, log.stamps, &derivatives)) {
    return std::nullopt;
  }
  request.model.model = leader->model.baseline;
  request.model.effects = leader->model.effects;
  request.model.covariance = InverseOf(InformationOf(derivatives, log.noise));
  if (!request.model.covariance.allFinite()) return std::nullopt;
  std::rotate(request.rivals.begin(), leader, leader + 1);
  return request;
}

}  // namespace fathom
