// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A whole log folder. Its files follow each other in the input, parted by lines of "====":
// log.yaml, command.csv, velocity.csv, pose.csv, detections.csv. An empty part stands for a missing
// file.

#include "fathom/base/input_error.h"
#include "fathom/log/log_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr char kSeparator[] = "====\n";
  const std::string input(reinterpret_cast<const char*>(data), size);
  std::string parts[5];
  std::size_t begin = 0;
  for (std::string& part : parts) {
    const std::size_t end = std::min(input.find(kSeparator, begin), input.size());
    part = input.substr(begin, end - begin);
    begin = std::min(end + sizeof(kSeparator) - 1, input.size());
  }
  fathom::LogText text;
  text.path = "log";
  text.log_yaml = {"log/log.yaml", parts[0]};
  if (!parts[1].empty()) text.command = {"log/command.csv", parts[1]};
  if (!parts[2].empty()) text.velocity = {"log/velocity.csv", parts[2]};
  if (!parts[3].empty()) text.pose = {"log/pose.csv", parts[3]};
  if (!parts[4].empty()) text.detections = {"log/detections.csv", parts[4]};
  try {
    fathom::ParseLog(text);
  } catch (const fathom::InputError&) {
  }
  return 0;
}
