// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a database of rosbag2.

#include "fathom/import/message/message_recording.h"
#include "fathom/import/recording/unpacked_file.h"
#include "fathom/import/ros/ros_definition.h"
#include "fathom/import/ros/rosbag2_database.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "read_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto open = [](const std::filesystem::path& file) {
    return fathom::OpenMessageRecording(
        file, fathom::OpenRosbag2Database(file), fathom::ParseRosDefinition);
  };
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  return ReadRecording(data, size, [&](const std::filesystem::path& file) {
    return fathom::LooksLikeZstd(bytes) ? fathom::OpenUnpacked(file, open) : open(file);
  });
}
