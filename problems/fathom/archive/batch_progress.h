// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>

namespace fathom {

// How far a batch is.
struct BatchProgress {
  std::string noun;  // "log" or "dive fit"
  std::size_t done = 0;
  std::size_t total = 0;
  std::string last_failure;  // "dive 3/run 1: timed_out"; empty: none so far
};

}  // namespace fathom
