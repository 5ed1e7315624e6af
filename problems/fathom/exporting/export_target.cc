// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/export_target.h"

namespace fathom {
namespace {

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::string NameOfVehicleFile(const ExportTarget& target) {
  return target.vehicle_file.empty() ? "--vehicle" : target.vehicle_file;
}

void AddTo(const std::vector<std::string>& more, std::vector<std::string>* sentences) {
  sentences->insert(sentences->end(), more.begin(), more.end());
}

std::string IdentifierOf(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  for (char& c : name) {
    if (!IsLetter(c) && !IsDigit(c)) c = '_';
  }
  if (name.empty() || !IsLetter(name.front())) name = "model_" + name;
  return name;
}

}  // namespace fathom
