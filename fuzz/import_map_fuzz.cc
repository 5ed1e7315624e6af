// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a map file; a map that is read must then import a table, or say why not.

#include "fathom/base/input_error.h"
#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/table/table_recording.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view kTable = "t [s],a,b,c\n0,1,2,0\n1,2,3,0\n2,0,0,0\n3,1,1,1\n";
  static const MemoryFile table(reinterpret_cast<const std::uint8_t*>(kTable.data()),
                                kTable.size());
  try {
    const auto map =
        fathom::ParseImportMap("m.yaml", std::string(reinterpret_cast<const char*>(data), size));
    const auto recording = fathom::OpenTable(table.path(), map.table);
    fathom::ImportLog(table.path(), *recording, map, std::nullopt);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
