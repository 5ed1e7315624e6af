// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "mistakes.h"

#include <algorithm>
#include <cstddef>

namespace fathom {

void ScaleForce(double factor, LogNumbers* log) {
  for (double& force : log->force) force *= factor;
}

void ScaleSpeed(double factor, LogNumbers* log) {
  for (double& speed : log->speed) speed *= factor;
}

void WritePulseWidths(LogNumbers* log) {
  for (double& force : log->force) force = 1500.0 + 8.0 * force;
}

void LoseLock(LogNumbers* log) {
  for (std::size_t i = 0; i < log->speed.size(); ++i) {
    if (i % 50 >= 20 && i % 50 < 29) log->speed[i] = 0.0;
  }
}

void GetStuck(LogNumbers* log) {
  double last = 0.0;
  for (std::size_t i = 0; i < log->speed.size(); ++i) {
    const bool is_stuck = log->time[i] >= 40.0 && log->time[i] <= 100.0;
    if (is_stuck) {
      log->speed[i] = last;
    } else {
      last = log->speed[i];
    }
  }
}

void WriteSentinels(LogNumbers* log) {
  for (std::size_t i = 60; i < log->speed.size(); i += 120) log->speed[i] = -32.768;
}

void HoldSamples(LogNumbers* log) {
  for (std::size_t i = 0; i < log->speed.size(); ++i) log->speed[i] = log->speed[i - i % 20];
}

void RepeatABlock(LogNumbers* log) {
  std::copy_n(log->speed.begin() + 200, 300, log->speed.begin() + 900);
}

void WriteAccelerations(LogNumbers* log) {
  const std::vector<double> speed = log->speed;
  constexpr std::size_t kReach = 5;  // rows of 0.1 s to both sides
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const std::size_t from = std::max(i, kReach) - kReach;
    const std::size_t to = std::min(i + kReach, speed.size() - 1);
    log->speed[i] = (speed[to] - speed[from]) / (log->time[to] - log->time[from]);
  }
}

}  // namespace fathom
