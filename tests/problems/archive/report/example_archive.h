// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/report/archive_report.h"

namespace fathom {

struct ExampleArchiveOptions {
  int num_dives = 30;     // at least 20
  int logs_per_dive = 4;  // at least 1
};

// The results of an archive of one vehicle in surge, sway and heave, made up: 14 kg of payload from
// the dive after 40 % of them on, a quadratic damping that grows in surge, one outlier and one
// diverged fit, a dive without any usable fit, and a log in each state. The same every time.
ArchiveReport ExampleArchive(const ExampleArchiveOptions& options = {});

}  // namespace fathom
