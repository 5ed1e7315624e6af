// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a model or verdict file; what is read must be written and read again to the same.

#include "fathom/base/input_error.h"
#include "fathom/vehicle/files/model_file.h"

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
    if (again.effects.size() != model.effects.size()) std::abort();
    for (std::size_t k = 0; k < model.effects.size(); ++k) {
      if (again.effects[k].effect != model.effects[k].effect) std::abort();
      if (again.effects[k].values != model.effects[k].values) std::abort();
      if (again.effects[k].setting.partner != model.effects[k].setting.partner) std::abort();
    }
  } catch (const fathom::InputError&) {
  }
  return 0;
}
