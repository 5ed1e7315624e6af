// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// What a program of Fathom ends with.
inline constexpr int kExitUsable = 0;       // a usable result
inline constexpr int kExitBadInput = 1;     // input or flags cannot be used
inline constexpr int kExitNoFit = 2;        // no usable fit, or no map of a recording
inline constexpr int kExitStrict = 3;       // of fathom_batch --strict: a log failed
inline constexpr int kExitOutOfMemory = 4;  // the memory does not suffice

}  // namespace fathom
