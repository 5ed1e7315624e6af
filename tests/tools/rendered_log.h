// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/csv/csv_table.h"

#include <filesystem>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "run_tool.h"
#include "saved_files.h"

namespace fathom {

// fathom_track on a log.
ToolRun Track(const std::filesystem::path& log, std::vector<std::string> more);

// Twelve rendered frames of a vehicle in surge in front of four markers, and its true poses in
// pose.csv. CTest makes it before the first test that needs it: rendered/.
const std::filesystem::path& RenderedLog();

// A copy that a test may damage.
std::filesystem::path CopyOfTheLog();

// pose.csv with its deviations.
CsvTable PosesIn(const std::filesystem::path& log);

}  // namespace fathom
