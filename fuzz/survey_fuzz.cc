// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as what fathom_batch --survey printed; what is read must be written again.

#include "fathom/base/input_error.h"
#include "fathom/open_log/survey.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto survey =
        fathom::ParseSurvey(std::string_view(reinterpret_cast<const char*>(data), size));
    fathom::ParseSurvey(fathom::FormatSurvey(survey));
  } catch (const fathom::InputError&) {
  }
  return 0;
}
