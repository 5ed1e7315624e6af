// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as tags and as a mount; tags that are read must write and read back.

#include "fathom/base/input_error.h"
#include "fathom/camera/mount_file.h"
#include "fathom/camera/tags_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    fathom::ParseMountFile("mount.yaml", text);
  } catch (const fathom::InputError&) {
  }
  fathom::MarkerMap map;
  try {
    map = fathom::ParseTagsFile("tags.yaml", text);
  } catch (const fathom::InputError&) {
    return 0;
  }
  const auto again = fathom::ParseTagsFile("again.yaml", fathom::FormatTagsFile(map));
  if (again.markers.size() != map.markers.size()) std::abort();
  return 0;
}
