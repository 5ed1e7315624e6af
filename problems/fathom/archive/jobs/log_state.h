// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>

namespace fathom {

// How the reprocessing of a log ended.
enum class LogState {
  kOk,                 // every program gave a usable result
  kPartial,            // some did
  kNothingToIdentify,  // at rest, without a command, too short
  kNoMap,              // a recording that does not say what its channels are, and no map does
  kNoModel,            // no fit is usable
  kRefused,            // its files break the format
  kCrashed,            // a signal ended a program
  kTimedOut,           // a program was killed at its limit of time
  kOutOfMemory,        // a program failed at its limit of memory
  kUnreadable,         // its files cannot be read: rights, a pipe, a device
  kDuplicate,          // a copy of another log, byte for byte
};

// Nothing if no state has this name.
std::optional<LogState> LogStateFromName(std::string_view name);

// "ok", "partial", "nothing_to_identify", "no_map", "no_model", "refused", "crashed", "timed_out",
// "out_of_memory", "unreadable", "duplicate".
std::string_view Name(LogState state);

// Whether somebody should look at it: neither ok nor a copy, nor a log without a motion to
// identify, nor a recording without a map.
bool IsFailure(LogState state);

}  // namespace fathom
