// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

namespace fathom {

// Every number of the model and its effects, a row each: name, value, std, 95 % interval, unit,
// frame, log, and whether it was identified or held. Lines that begin with # head it. Empty cells
// are not known.
ExportedFile CsvTable(const ExportModel& model, const ExportTarget& target);

}  // namespace fathom
