// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fathom {

// Every row of every public table of a results file as one line, "fits|dive 1/run 2|surge|...",
// sorted; without the columns `seconds` and `peak_mb` of `logs`, which no two runs share.
std::vector<std::string> PublicRows(const std::filesystem::path& results);

// Those of one log in `logs`, `fits`, `scores`, `verdicts`, `causes` and `findings`.
std::vector<std::string> PublicRowsOf(const std::string& log, const std::filesystem::path& results);

// The rows of a query, columns joined by "|".
std::vector<std::string> Query(const std::string& sql, const std::filesystem::path& results);

// "status: message" of each log, by its path.
std::map<std::string, std::string> StatesOf(const std::filesystem::path& results);

}  // namespace fathom
