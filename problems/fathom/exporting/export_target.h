// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/files/vehicle_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What an exported file tells beside the model.
struct ExportTarget {
  std::string name;                     // an identifier: IdentifierOf()
  std::string origin;                   // "fathom_export 0.1.0 (abc1234), 2026-05-03"
  std::optional<Vehicle> vehicle = {};  // the vehicle file, where it is given
  double matched_speed = 0.5;           // where drag of another law equals the model's [m/s]
  std::string vehicle_file = {};        // its path, for messages
};

// A file of another program.
struct ExportedFile {
  std::string text;

  // What the format does not hold of the model, or needs beside it: a sentence each, which also
  // stands in the text.
  std::vector<std::string> remarks = {};

  // Checks that failed, a sentence each: the file is then not to be written.
  std::vector<std::string> problems = {};
};

// What a message about the vehicle file begins with: its path, or the flag that would give it.
std::string NameOfVehicleFile(const ExportTarget& target);

// Appends sentences to others.
void AddTo(const std::vector<std::string>& more, std::vector<std::string>* sentences);

// The stem of a file's name as an identifier: letters, digits and _, no digit first. What is
// something else becomes _.
std::string IdentifierOf(const std::filesystem::path& file);

}  // namespace fathom
