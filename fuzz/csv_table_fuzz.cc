// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a command, a velocity, a pose, a single CSV, and a table whose stamps may repeat.

#include "fathom/base/input_error.h"
#include "fathom/log/csv_table.h"
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
  fathom::CsvSpec tags;
  tags.required = {"tag_id"};
  tags.allow_equal_stamps = true;
  Try([&] { fathom::ParseCsvTable("detections.csv", text, tags); });
  return 0;
}
