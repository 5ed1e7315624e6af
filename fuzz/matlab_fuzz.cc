// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a .mat of each version; what is listed must then be readable.

#include "fathom/base/input_error.h"
#include "fathom/import/matlab/mat4_file.h"
#include "fathom/import/matlab/mat5_file.h"
#include "fathom/import/matlab/mat73_file.h"
#include "fathom/import/matlab/matlab_recording.h"
#include "fathom/import/recording/contents_json.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "memory_file.h"

// The HDF5 library does not free all that it took for some damaged files.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const MemoryFile file(data, size);
  try {
    std::unique_ptr<fathom::MatlabFile> opened;
    if (fathom::LooksLikeMat73(bytes)) {
      opened = fathom::OpenMat73(file.path());
    } else if (fathom::LooksLikeMat5(bytes)) {
      opened = fathom::OpenMat5(file.path());
    } else {
      opened = fathom::OpenMat4(file.path());
    }
    const auto recording = fathom::OpenMatlab(file.path(), std::move(opened));
    fathom::FormatContents(recording->contents());
    std::vector<fathom::Selection> selections;
    for (const fathom::Channel& channel : recording->contents().channels) {
      fathom::Selection selection = {channel.name, {}};
      for (const fathom::Field& field : channel.fields) selection.fields.push_back(field.name);
      selections.push_back(selection);
    }
    recording->Read(selections, [](std::size_t, double, std::span<const double>) {});
  } catch (const fathom::InputError&) {
  }
  return 0;
}
