// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <string>

namespace fathom {

// A line on stderr that says how far a tool is, where stderr is a terminal; nothing elsewhere. Gone
// when it goes out of scope.
class Progress {
 public:
  // "frame 120 of 491" for the noun "frame".
  explicit Progress(std::string noun);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `expected` 0: not known. `note`: what else to say, behind it.
  void Show(int done, int expected, const std::string& note = "");

 private:
  std::string noun_;
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace fathom
