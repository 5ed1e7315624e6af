// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a state file of a stream; what is read must be written and read as the same, and go
// on.

#include "fathom/adaptive/follower_file.h"
#include "fathom/base/input_error.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fathom::AdaptiveOptions options = {.gains = fathom::AdaptiveGains{-1, {1, 1, 1, 1}}};
  const auto parse = [&](std::string_view text) {
    return fathom::ParseFollower("s.json", text, fathom::Dof::kSurge, options);
  };
  try {
    fathom::AdaptiveFollower follower =
        parse(std::string_view(reinterpret_cast<const char*>(data), size));
    const std::string text = fathom::FormatFollower(fathom::Dof::kSurge, options, follower);
    if (fathom::FormatFollower(fathom::Dof::kSurge, options, parse(text)) != text) std::abort();
    const double next = follower.state().t + 1.0;
    if (next > follower.state().t) follower.Add(next, 1.0, 0.1);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
