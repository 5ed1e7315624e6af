// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/sources/source.h"

#include "fathom/base/input_error.h"

#include <fmt/format.h>

namespace fathom {

std::string_view Name(Source source) {
  return source == Source::kPoseEstimator ? "pose_estimator" : "camera";
}

std::string_view NameInText(Source source) {
  return source == Source::kPoseEstimator ? "velocity.csv" : "camera";
}

Source ParseSource(const std::string& name) {
  for (const Source source : {Source::kPoseEstimator, Source::kCamera}) {
    if (Name(source) == name) return source;
  }
  throw InputError(fmt::format("is '{}', expected pose_estimator or camera.", name));
}

}  // namespace fathom
