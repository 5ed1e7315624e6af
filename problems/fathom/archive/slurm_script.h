// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch.h"

#include <filesystem>
#include <string>

namespace fathom {

// A job script for Slurm that reprocesses the archive in `num_parts` parts: as a job array each
// task does one into a database on the node's own disk and copies it beside the results; with the
// word `merge` behind it the script joins them, does what is left and writes the report and the
// table. Throws InputError unless `num_parts` is 1 to 10000.
std::string SlurmScript(const BatchOptions& options,
                        int num_parts,
                        const std::filesystem::path& report,
                        const std::filesystem::path& csv = {});

// The two commands that submit it.
std::string HowToSubmit(const std::filesystem::path& script, int num_parts);

}  // namespace fathom
