// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as pose.yaml; remarks that are read must write and read back.

#include "fathom/base/input_error.h"
#include "fathom/log/pose_remarks.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::vector<fathom::Remark> remarks;
  try {
    remarks = fathom::ParsePoseRemarks("pose.yaml", text, 900);
  } catch (const fathom::InputError&) {
    return 0;
  }
  const std::string again = fathom::FormatPoseRemarks(remarks, 900);
  if (fathom::ParsePoseRemarks("again.yaml", again, 900) != remarks) std::abort();
  return 0;
}
