// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/report/panel.h"

#include <filesystem>
#include <vector>

namespace fathom {

// Draws a panel into a file for a paper or a slide: .svg or .png by its extension. Throws
// InputError for another extension, if the file cannot be written, or if gnuplot is not installed.
void WriteFigure(const TimePanel& panel, const std::filesystem::path& path);

// Dots and 95 % intervals, one small plot for each parameter.
void WriteFigure(const std::vector<ParameterPanel>& panels, const std::filesystem::path& path);

}  // namespace fathom
