// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a .mat of each version.

#include "fathom/import/matlab/mat4_file.h"
#include "fathom/import/matlab/mat5_file.h"
#include "fathom/import/matlab/mat73_file.h"
#include "fathom/import/matlab/matlab_recording.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "read_recording.h"

// The HDF5 library does not free all that it took for some damaged files.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::unique_ptr<fathom::MatlabFile> (*open)(const std::filesystem::path&) = fathom::OpenMat4;
  if (fathom::LooksLikeMat5(bytes)) open = fathom::OpenMat5;
  if (fathom::LooksLikeMat73(bytes)) open = fathom::OpenMat73;
  return ReadRecording(data, size, [&](const std::filesystem::path& file) {
    return fathom::OpenMatlab(file, open(file));
  });
}
