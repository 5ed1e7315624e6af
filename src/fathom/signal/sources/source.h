// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// Where the motion comes from: velocity.csv, or the derivative of pose.csv.
enum class Source { kPoseEstimator, kCamera };

// "pose_estimator" or "camera".
std::string_view Name(Source source);

// What a sentence calls it: "velocity.csv" or "camera".
std::string_view NameInText(Source source);

// Throws InputError, listing the names there are, in the form of ParseDof().
Source ParseSource(const std::string& name);

}  // namespace fathom
