// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/unusual_mass.h"

#include "fathom/base/short_number.h"
#include "fathom/findings/inertia_check.h"
#include "fathom/findings/log_check.h"

#include <fmt/format.h>

namespace fathom {

std::optional<double> UnusualMasses(const Log& log, Dof dof, const Identification& model) {
  if (IsAngular(dof) || !model.is_usable || model.fitted.force_unit != ForceUnit(dof)) {
    return std::nullopt;
  }
  const std::optional<Body> body = BodyOf({&log, 1});
  if (!body) return std::nullopt;
  const double inertia = model.fitted.model.inertia;
  if (!(inertia > UsualInertia(dof, *body))) return std::nullopt;
  return inertia / body->mass;
}

std::optional<Finding> CheckUsualMass(const Log& log, Dof dof, const Identification& model) {
  const std::optional<double> masses = UnusualMasses(log, dof, model);
  if (!masses) return std::nullopt;
  return Finding{Severity::kNote,
                 "heavy",
                 fmt::format("The inertia is {} times the dry mass (up to 3 is usual).",
                             ShortNumber(*masses, 2))};
}

}  // namespace fathom
