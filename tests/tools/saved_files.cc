// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "saved_files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace fathom {

std::vector<std::string> LinesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string TextOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string HeaderOf(const std::string& page) {
  const std::size_t from = page.find("<header"), to = page.find("</header>");
  if (from == std::string::npos || to == std::string::npos) return "";
  return page.substr(from, to - from);
}

nlohmann::json JsonOf(const std::filesystem::path& path) {
  return nlohmann::json::parse(TextOf(path));
}

std::vector<double> CsvColumns::Values(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::runtime_error("no column " + name);
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row.at(found - names.begin()));
  return values;
}

CsvColumns ReadColumns(const std::filesystem::path& path) {
  CsvColumns columns;
  std::istringstream file(TextOf(path));
  std::string line, cell;
  std::getline(file, line);
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) {
    columns.names.push_back(cell);
  }
  while (std::getline(file, line)) {
    auto& row = columns.rows.emplace_back();
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) {
      row.push_back(std::stod(cell));
    }
  }
  return columns;
}

double NumberBehind(const std::string& label, const std::string& text, const std::string& from) {
  const std::size_t start = text.find(from);
  const std::size_t at = start == std::string::npos ? start : text.find(label, start);
  if (at == std::string::npos) return std::numeric_limits<double>::quiet_NaN();
  return std::strtod(text.c_str() + at + label.size(), nullptr);
}

}  // namespace fathom
