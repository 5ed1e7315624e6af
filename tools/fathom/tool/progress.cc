// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/progress.h"

#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace fathom {

Progress::Progress(std::string noun)
    : noun_(std::move(noun)), is_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (is_shown_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::Show(int done, int expected, const std::string& note) {
  if (!is_terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (is_shown_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  is_shown_ = true;
  fmt::print(stderr, "\r\x1b[K{} {}", noun_, done);
  if (expected > 0) fmt::print(stderr, " of {}", expected);
  if (!note.empty()) fmt::print(stderr, "{}", note);
  std::fflush(stderr);
}

}  // namespace fathom
