// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fathom {

// The bytes of a file that a tool has written; empty if there is none.
std::string TextOf(const std::filesystem::path& path);

std::vector<std::string> LinesOf(const std::string& text);

// What a page says above its first section: title, first sentences and tiles.
std::string HeaderOf(const std::string& page);

nlohmann::json JsonOf(const std::filesystem::path& path);

// A CSV, read without Fathom's own reader: plain numbers below one line of names.
struct CsvColumns {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  // Of the column `name`, which has to be there.
  std::vector<double> Values(const std::string& name) const;
};
CsvColumns ReadColumns(const std::filesystem::path& path);

// The number behind `label` in a tool's output: 0.0994 for "NMAE " in "NMAE 0.0994 over". NaN if
// there is none. The search starts at `from` where that is given.
double NumberBehind(const std::string& label,
                    const std::string& text,
                    const std::string& from = "");

}  // namespace fathom
