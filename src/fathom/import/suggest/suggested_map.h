// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// A map for a recording, as its channels and fields are called.
struct SuggestedMap {
  std::string text;  // of a map file, with comments for the one who edits it

  // Whether a program may use it unseen: the format itself says what its channels are. The names in
  // a table do not, but those of a known program.
  bool is_ready = false;

  // Why it is not, where the vehicle that was given does not go with it; else empty.
  std::string why_not_ready;

  // What has to be known for it and the recording does not say: which output drives which motor.
  // Else empty.
  std::string unknown;

  // Whether it names a stream: else nothing was recognised, and it is a comment.
  bool NamesAStream() const;

  // Whether it lacks only the vehicle whose thrusters the recording's outputs drive.
  bool needs_vehicle = false;
};

// As JSON, schema "fathom-suggestion-1".
std::string FormatSuggestion(const SuggestedMap& map);

}  // namespace fathom
