// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as an MCAP file.

#include "fathom/import/message/message_recording.h"
#include "fathom/import/ros/mcap_file.h"
#include "fathom/import/ros/ros_definition.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "read_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ReadRecording(data, size, [](const std::filesystem::path& file) {
    return fathom::OpenMessageRecording(file, fathom::OpenMcap(file), fathom::ParseRosDefinition);
  });
}
