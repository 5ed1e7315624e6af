// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/read_log.h"

#include <filesystem>
#include <map>
#include <string>

namespace fathom {

using LogFiles = std::map<std::string, std::string>;  // text by name

inline constexpr char kReadPose[] =
    "t,x,y,z,qx,qy,qz,qw\n0.5,1,2,3,0,0,0,1\n0.6,1,2,3,0.5,0.5,0.5,0.5\n";

// A log that can be read, with some files put in place of its own; without those whose text is "-".
std::filesystem::path FolderWith(const LogFiles& changes);

// The message of ReadLog() on that folder, without the folder in front.
std::string RefusalOf(const LogFiles& changes, const ReadLogOptions& options = {});

}  // namespace fathom
