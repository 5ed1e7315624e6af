// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <vector>

namespace fathom {

// What a remark is about, for code that has to decide by it; its text is for people only.
enum class RemarkKind {
  kGeneral,     // what was passed over or dropped
  kDetections,  // of detections.csv, or of the poses made from it
  kPoses,       // of pose.csv, as pose.yaml says
  kSurfaces,    // of fins and shafts, which a model of one DOF leaves out
  kLostMotion,  // these poses may be short of motion: a single marker was seen face on
};

// One sentence to be told of a log.
struct Remark {
  RemarkKind kind = RemarkKind::kGeneral;
  std::string text;

  bool operator==(const Remark&) const = default;
};

std::vector<std::string> TextsOf(std::span<const Remark> remarks);

// Whether a remark is of this kind.
bool Holds(std::span<const Remark> remarks, RemarkKind kind);

}  // namespace fathom
