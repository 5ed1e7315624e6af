// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/synthesize/experiment/experiment.h"

#include <filesystem>
#include <string>

namespace fathom {

// Reads an experiment file (YAML; docs/file_formats.md) and the commands that it replays, which are
// looked for in its folder. Throws InputError, naming file, line and key, for whatever breaks the
// format.
Experiment ReadExperimentFile(const std::filesystem::path& path);

// The same from memory, without the replayed commands; `name` stands for the file in messages.
Experiment ParseExperiment(const std::string& name, const std::string& text);

}  // namespace fathom
