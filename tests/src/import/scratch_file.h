// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <string>
#include <vector>

#include "error_from.h"

namespace fathom {

// Writes a file of the running test, and gives its path.
std::filesystem::path ScratchFile(const std::string& name, const std::string& bytes);

// The samples of one selection.
struct ReadSamples {
  std::vector<double> time;
  std::vector<std::vector<double>> rows;
  std::vector<std::string> remarks;
};

ReadSamples ReadAll(const Recording& recording, const Selection& selection);

// The channel of this name; fails the test if there is none.
Channel ChannelNamed(const Contents& contents, const std::string& name);

}  // namespace fathom
