// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace fathom {

// Progress for a stderr that is a file: a line each `period` with what was last shown, whether
// anything has changed since or not, so that a reader knows the program alive. Nothing at all of
// work that takes less than one period.
class ProgressLines {
 public:
  // `name`: of the tool, which each line begins with. `now`: what is shown until Show() is called.
  ProgressLines(std::string name, std::string now, std::chrono::milliseconds period);
  ~ProgressLines();
  ProgressLines(const ProgressLines&) = delete;
  ProgressLines& operator=(const ProgressLines&) = delete;

  void Show(std::string now);

 private:
  void Print();

  const std::string name_;
  const std::chrono::milliseconds period_;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::string now_;
  bool is_ended_ = false;
  std::thread thread_;  // last: it uses all others
};

}  // namespace fathom
