// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/images/png_file.h"

#include <glog/logging.h>
#include <png.h>

namespace fathom {

// By libpng itself: OpenCV's imgcodecs would bring 118 libraries with it, a tenth of a second each
// time that a program begins.
std::string EncodePng(const GrayImage& image) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = PNG_FORMAT_GRAY;
  header.flags = PNG_IMAGE_FLAG_FAST;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
  png_alloc_size_t size = bytes.size();
  CHECK(png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
      << header.message;
  bytes.resize(size);
  return bytes;
}

}  // namespace fathom
