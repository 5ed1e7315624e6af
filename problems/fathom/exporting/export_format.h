// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

#include <optional>
#include <string_view>

namespace fathom {

// What a model can be written as.
enum class ExportFormat { kC, kGazebo, kMss };

// "c", "gazebo", "mss".
std::string_view Name(ExportFormat format);

// "a header in C99", "a model of SDF 1.10", "a function of MATLAB and Octave".
std::string_view DescriptionOf(ExportFormat format);

// Throws InputError, listing the names there are: "is 'urdf', expected ...", for the name of a flag
// to be put before it.
ExportFormat ParseExportFormat(std::string_view name);

// The model in a format, once CheckExport() finds nothing. Throws InputError for what the format
// needs and does not get.
ExportedFile Export(const ExportModel& model, const ExportTarget& target, ExportFormat format);

}  // namespace fathom
