// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/table/table_layout.h"

#include <filesystem>
#include <memory>

namespace fathom {

// A table of text, CSV of any shape; docs/import.md. Its one channel has the name of the file
// without the ending. A field is a column that holds numbers. A cell that is empty or holds no
// number is NaN; rows with a wrong number of cells, or without a stamp, are passed over and counted
// in a remark. Throws InputError, naming file and line, for a file that is no such table.
std::unique_ptr<Recording> OpenTable(const std::filesystem::path& path,
                                     const TableOptions& options = {});

}  // namespace fathom
