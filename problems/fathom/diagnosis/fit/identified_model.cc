// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/identified_model.h"

#include "fathom/output_error/output_error.h"
#include "fathom/signal/joined_signals.h"

#include <utility>

namespace fathom {

std::optional<IdentifiedModel> IdentifiedModelOf(std::span<const Log> logs, Dof dof) {
  const Signals signals = JoinSignals(logs, dof, std::nullopt).all;
  if (signals.train.empty()) return std::nullopt;
  OutputErrorOptions options;
  options.weighting = Weighting::kAuto;
  options.output = OutputOf(signals.train);
  OutputErrorSummary summary = FitOutputError(signals.train, options);
  if (!summary.IsUsable()) return std::nullopt;
  return IdentifiedModel{summary.model, std::move(summary.covariance)};
}

}  // namespace fathom
