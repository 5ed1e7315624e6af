// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>

namespace fathom {

// What a model can be written as.
enum class ExportFormat { kC, kCsv, kGazebo, kMss, kStonefish, kUuv, kVrx };
inline constexpr std::array<ExportFormat, 7> kExportFormats = {ExportFormat::kC,
                                                               ExportFormat::kCsv,
                                                               ExportFormat::kGazebo,
                                                               ExportFormat::kMss,
                                                               ExportFormat::kStonefish,
                                                               ExportFormat::kUuv,
                                                               ExportFormat::kVrx};

// "c", "csv", "gazebo".
std::string_view Name(ExportFormat format);

// "c, csv, gazebo, ... or vrx".
std::string ExportFormatNames();

// "a header in C99", "a model of SDF 1.10", "a function of MATLAB and Octave".
std::string_view DescriptionOf(ExportFormat format);

// Throws InputError, listing the names there are: "is 'urdf', expected ...", for the name of a flag
// to be put before it.
ExportFormat ParseExportFormat(std::string_view name);

}  // namespace fathom
