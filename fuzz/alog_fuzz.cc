// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as an .alog of MOOS.

#include "fathom/import/moos/alog_recording.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "read_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ReadRecording(
      data, size, [](const std::filesystem::path& file) { return fathom::OpenAlog(file); });
}
