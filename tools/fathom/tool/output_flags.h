// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace fathom {

// A flag and the file that it asks for: none if the name is empty.
struct OutputFlag {
  std::string name;
  std::string file;
};

// Throws InputError, naming the flag and before any work is done, if a file cannot be written, if
// two flags ask for the same one, or if it would take the place of an input: of one of the files
// `inputs`, or of what a log holds that is one of the folders `inputs`.
void RequireOutputs(const std::vector<OutputFlag>& outputs, const std::vector<std::string>& inputs);

}  // namespace fathom
