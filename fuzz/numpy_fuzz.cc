// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a .npy or a .npz.

#include "fathom/import/numpy/npy_header.h"
#include "fathom/import/numpy/numpy_recording.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "read_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto open = fathom::LooksLikeNpy(bytes) ? fathom::OpenNpy : fathom::OpenNpz;
  return ReadRecording(data, size, [&](const std::filesystem::path& file) { return open(file); });
}
