// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/table/table_layout.h"

#include <filesystem>
#include <memory>

namespace fathom {

// Opens a recording of any format that Fathom reads, by what its first bytes are, not by its name;
// docs/import.md. `table`: how to read it if it is a table of text. Throws InputError, naming the
// file and the formats there are, for anything else.
std::unique_ptr<Recording> OpenRecording(const std::filesystem::path& path,
                                         const TableOptions& table = {});

}  // namespace fathom
