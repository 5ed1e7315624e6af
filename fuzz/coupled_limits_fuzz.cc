// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as the limits of an experiment of several DOFs; a vehicle at rest keeps those that are
// read.

#include "fathom/base/input_error.h"
#include "fathom/coupled_planning/coupled_limits.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const auto limits = fathom::ParseCoupledLimits("lake.yaml", text);
    const std::vector<fathom::CoupledState> rest(1);
    if (!fathom::KeepsLimits(rest, limits)) std::abort();
  } catch (const fathom::InputError&) {
  }
  return 0;
}
