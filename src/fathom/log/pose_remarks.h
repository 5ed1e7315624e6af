// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/remark.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// pose.yaml of a log: what whoever made pose.csv has to say of it, so that it is said again
// wherever these poses are used; docs/file_formats.md.

// The remarks, of kind kPoses or kLostMotion; `num_poses` is the number of rows of pose.csv. Throws
// InputError, naming file, line and key, for whatever breaks the format, and if the remarks are on
// another number of poses.
std::vector<Remark> ParsePoseRemarks(const std::string& name,
                                     const std::string& text,
                                     std::size_t num_poses);

// A file that reads back as the same remarks; those of other kinds become kPoses.
std::string FormatPoseRemarks(std::span<const Remark> remarks, std::size_t num_poses);

}  // namespace fathom
