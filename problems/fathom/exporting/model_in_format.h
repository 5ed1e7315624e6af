// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_format.h"
#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

namespace fathom {

// The model in a format, once CheckExport() finds nothing. Throws InputError for what the format
// needs and does not get.
ExportedFile Export(const ExportModel& model, const ExportTarget& target, ExportFormat format);

}  // namespace fathom
