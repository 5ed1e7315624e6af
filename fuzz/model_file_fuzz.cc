// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a model or verdict file; what is read must be written and read again to the same.

#include "fathom/base/input_error.h"
#include "fathom/vehicle/model_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto model =
        fathom::ParseModel("m.json", std::string_view(reinterpret_cast<const char*>(data), size));
    const auto again = fathom::ParseModel("m.json", fathom::FormatModel(model));
    if (fathom::ToVector(again.model) != fathom::ToVector(model.model)) std::abort();
  } catch (const fathom::InputError&) {
  }
  return 0;
}
