// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/report/archive_report.h"

#include <string>
#include <vector>

namespace fathom {

// The charts of parameters over dives, as JSON for web/parameter_charts.js: a list with an entry
// for each vehicle and DOF. `dives` are all dives that the page knows; those of a vehicle are those
// that have a log or a joint fit of it, and a place in a chart counts these.
//
//   vehicle, dof
//   dives    places in `dives`
//   charts   parameter, unit, range [from, to], ticks [[value, label]],
//            points [[place, value, std or null, text]], outliers [place],
//            changes {kind, at, until, before, after}, in places
std::string ParameterChartsJson(const ArchiveReport& report, const std::vector<std::string>& dives);

}  // namespace fathom
