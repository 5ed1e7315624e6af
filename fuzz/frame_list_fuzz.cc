// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/input_error.h"
#include "fathom/images/frame_list.h"

#include <cstddef>
#include <cstdint>
#include <string>

// The same bytes as frames.csv and as frame_times.csv.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    fathom::ParseFrameList("frames.csv", text);
  } catch (const fathom::InputError&) {
  }
  try {
    fathom::ParseFrameTimes("frame_times.csv", text);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
