// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/progress_lines.h"

#include <cstdio>
#include <utility>

#include <fmt/format.h>

namespace fathom {

ProgressLines::ProgressLines(std::string name, std::string now, std::chrono::milliseconds period)
    : name_(std::move(name)), period_(period), now_(std::move(now)), thread_([this] { Print(); }) {}

ProgressLines::~ProgressLines() {
  {
    const std::lock_guard lock(mutex_);
    is_ended_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

void ProgressLines::Show(std::string now) {
  const std::lock_guard lock(mutex_);
  now_ = std::move(now);
}

void ProgressLines::Print() {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, period_, [this] { return is_ended_; })) {
    fmt::print(stderr, "{}: {}\n", name_, now_);
    std::fflush(stderr);
  }
}

}  // namespace fathom
