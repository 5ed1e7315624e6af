// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/unusual_mass.h"

#include "fathom/base/short_number.h"
#include "fathom/findings/inertia_check.h"
#include "fathom/findings/log_check.h"

#include <fmt/format.h>

namespace fathom {

std::optional<UnusualMass> UnusualMassOf(const Log& log, Dof dof, const Identification& model) {
  if (IsAngular(dof) || !model.is_usable || model.fitted.force_unit != ForceUnit(dof)) {
    return std::nullopt;
  }
  const std::optional<Body> body = BodyOf({&log, 1});
  if (!body) return std::nullopt;
  const double inertia = model.fitted.model.inertia;
  const double usual = UsualInertia(dof, *body);
  if (!(inertia > usual)) return std::nullopt;
  return UnusualMass{inertia / body->mass, usual / body->mass};
}

std::optional<Finding> CheckUsualMass(const Log& log, Dof dof, const Identification& model) {
  const auto unusual = UnusualMassOf(log, dof, model);
  if (!unusual) return std::nullopt;
  return Finding{Severity::kNote,
                 "heavy",
                 fmt::format("The inertia is {} times the dry mass (up to {} is usual).",
                             ShortNumber(unusual->inertia, 2),
                             ShortNumber(unusual->usual, 2))};
}

}  // namespace fathom
