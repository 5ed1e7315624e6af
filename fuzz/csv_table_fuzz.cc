// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a command, a velocity, a pose, a single CSV, and detections.

#include "fathom/base/input_error.h"
#include "fathom/log/csv/csv_table.h"
#include "fathom/log/log_streams.h"
#include "fathom/log/log_text.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace {

template <typename Read>
void Try(Read read) {
  try {
    read();
  } catch (const fathom::InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Try([&] { fathom::ParseCommand("command.csv", text).Remark(); });
  Try([&] { fathom::ParseVelocity("velocity.csv", text).Remark(); });
  Try([&] { fathom::ParsePose("pose.csv", text).Remark(); });
  Try([&] { fathom::ParseSingleCsv("run.csv", text, fathom::Dof::kYaw); });
  Try([&] { fathom::ParseDetections("detections.csv", text).Remark(); });
  return 0;
}
