// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/input_error.h"
#include "fathom/images/image_file.h"

#include <cstddef>
#include <cstdint>
#include <string>

// What goes in front of the decoders of libjpeg-turbo and OpenCV, and what they make of it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    fathom::DecodeImage("image", text);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
