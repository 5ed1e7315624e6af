// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/report/dive_summary.h"

#include <string>
#include <vector>

namespace fathom {

// The dives, their logs and findings as JSON for the scripts of the page. Keys are short where they
// repeat thousands of times.
//
//   dives  name, start, logs (places), lost (logs without a model), red, yellow (findings),
//          dofs by name: model 1, h (held-out NMAE), p (prediction NMAE), causes, verdicts
//   worst  places in dives, worst first
//   logs   [path, state, message, {dof: address of the page of its diagnosis}, vehicle]
//   findings  [place in logs, dof, severity, text]
std::string DivesJson(const ArchiveReport& report, const std::vector<DiveSummary>& summaries);

// A path relative to the page as an address: every byte that could mean something else in one is
// written as %XX, so that it is neither a scheme nor a query.
std::string AddressOf(const std::string& path);

}  // namespace fathom
