// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_container.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is an SQLite database.
bool LooksLikeSqlite(std::string_view first_bytes);

// A database of rosbag2 (.db3). Types whose definition it does not hold are those of
// KnownDefinition(). Throws InputError, naming the file, for another database.
std::unique_ptr<MessageContainer> OpenRosbag2Database(const std::filesystem::path& path);

}  // namespace fathom
