// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as the limits of an experiment.

#include "fathom/base/input_error.h"
#include "fathom/planning/plan_limits.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    fathom::ParsePlanLimits("tank.yaml", text);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
