// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_container.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is a bag of ROS 1.
bool LooksLikeRos1Bag(std::string_view first_bytes);

// A bag of ROS 1, version 2.0, with chunks that are plain, bz2 or lz4. It is read from its first
// byte to its last, so that its index may be missing; where it has one, that lists it. Throws
// InputError for another version.
std::unique_ptr<MessageContainer> OpenRos1Bag(const std::filesystem::path& path);

}  // namespace fathom
