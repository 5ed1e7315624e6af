// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as an archive.yaml; what is read must then tell the dive of a log.

#include "fathom/archive/dives/archive_settings.h"
#include "fathom/base/input_error.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto settings = fathom::ParseArchiveSettings(
        "archive.yaml", std::string(reinterpret_cast<const char*>(data), size));
    fathom::DiveOfPath("cruise 3/2024-05-01 dive/run 12.csv", settings);
    fathom::IsLeftOut("cruise 3/2024-05-01 dive/run 12.csv", settings);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
