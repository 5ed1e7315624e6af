// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/log_state.h"

namespace fathom {

std::string_view Name(LogState state) {
  switch (state) {
    case LogState::kOk:
      return "ok";
    case LogState::kPartial:
      return "partial";
    case LogState::kNothingToIdentify:
      return "nothing_to_identify";
    case LogState::kNoMap:
      return "no_map";
    case LogState::kNoModel:
      return "no_model";
    case LogState::kRefused:
      return "refused";
    case LogState::kCrashed:
      return "crashed";
    case LogState::kTimedOut:
      return "timed_out";
    case LogState::kOutOfMemory:
      return "out_of_memory";
    case LogState::kUnreadable:
      return "unreadable";
    case LogState::kDuplicate:
      return "duplicate";
  }
  return "";
}

std::optional<LogState> LogStateFromName(std::string_view name) {
  for (int i = 0; i <= static_cast<int>(LogState::kDuplicate); ++i) {
    if (Name(static_cast<LogState>(i)) == name) return static_cast<LogState>(i);
  }
  return std::nullopt;
}

bool IsFailure(LogState state) {
  return state != LogState::kOk && state != LogState::kNothingToIdentify &&
         state != LogState::kNoMap && state != LogState::kDuplicate;
}

}  // namespace fathom
