// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

// The files of data/maps and data/import, embedded at build time: a program has no folder to find
// them in.
namespace fathom::data_files {

extern const std::string_view ardupilot, moos, px4, rock, ros, tlog, uvms_simlab;  // maps
extern const std::string_view column_names, mavlink_messages, ros_types;

}  // namespace fathom::data_files
