// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/csv/csv_table.h"

namespace fathom {

// Whether the stamps of a log's streams can be seconds on one clock. Both throw InputError, naming
// the files and what was found.

// A motion stream whose median step is not between 1e-5 s and 10 s is not in seconds. A command may
// be held for longer; it is refused only if it also lasts ten times longer than the motion.
void RefuseStampsThatAreNotSeconds(const CsvTable& command, const CsvTable& motion);

// The command and the motion must share some time.
void RefuseDisjointClocks(const CsvTable& command, const CsvTable& motion);

}  // namespace fathom
