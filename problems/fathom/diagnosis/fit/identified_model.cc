// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/identified_model.h"

#include "fathom/identification/identification.h"
#include "fathom/identification/log_agreement.h"
#include "fathom/log/distinct_names.h"
#include "fathom/signal/joined_signals.h"

#include <cstddef>
#include <utility>

namespace fathom {

Identified IdentifiedModelOf(std::span<const Log> logs, Dof dof) {
  const JoinedSignals joined = JoinSignals(logs, dof, std::nullopt);
  const IdentificationOptions options;
  Identification together = Identify(joined.all, joined.all, Family::kOutputError, options);
  Identified identified;
  if (!together.is_usable) {
    identified.why_none = std::move(together.message);
    return identified;
  }
  FittedModel& fitted = together.fitted;
  const std::size_t num_of_fit = fitted.caveats.size();
  if (logs.size() > 1) WidenByAgreement(DistinctNames(logs), joined, options, &together);
  identified.remarks.assign(fitted.caveats.begin() + static_cast<std::ptrdiff_t>(num_of_fit),
                            fitted.caveats.end());
  identified.model = IdentifiedModel{fitted.model, std::move(fitted.covariance)};
  return identified;
}

}  // namespace fathom
