// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a mount; what is read is a pose.

#include "fathom/base/input_error.h"
#include "fathom/camera/mount_file.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  fathom::Pose pose;
  try {
    pose = fathom::ParseMountFile("mount.yaml", text);
  } catch (const fathom::InputError&) {
    return 0;
  }
  if (!pose.translation.allFinite()) std::abort();
  if (!(std::abs(pose.rotation.norm() - 1.0) < 1e-9)) std::abort();
  return 0;
}
