// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/ros/ros_container.h"

#include <filesystem>
#include <memory>

namespace fathom {

// A file of ROS messages as a recording; docs/import.md. A channel is a topic. Its stamps are the
// times at which the messages were written down; the map may take those of the messages' headers
// instead. Fields are the numbers of the first message by their paths, "pose.pose.position.x",
// "data[3]".
std::unique_ptr<Recording> OpenRosRecording(const std::filesystem::path& path,
                                            std::unique_ptr<RosContainer> container);

}  // namespace fathom
