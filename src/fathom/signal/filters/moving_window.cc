// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/moving_window.h"

#include <algorithm>

#include <glog/logging.h>

namespace fathom {
namespace {

// Stamps count as inside a window that they miss by rounding: the share of the window that a stamp
// may lie outside.
constexpr double kRounding = 1e-6;

}  // namespace

MovingWindow::MovingWindow(std::span<const double> time, double width)
    : time_(time), width_(width) {
  CHECK_GT(width, 0.0);
}

void MovingWindow::FindPiece(std::size_t i) {
  if (piece_begin_ <= i && i < piece_end_) return;
  const double longest = 0.5 * width_ * (1.0 + kRounding);
  for (piece_begin_ = i; piece_begin_ > 0; --piece_begin_) {
    if (time_[piece_begin_] - time_[piece_begin_ - 1] > longest) break;
  }
  for (piece_end_ = i + 1; piece_end_ < time_.size(); ++piece_end_) {
    if (time_[piece_end_] - time_[piece_end_ - 1] > longest) break;
  }
  first_ = past_last_ = piece_begin_;
}

void MovingWindow::MoveTo(std::size_t i) {
  CHECK_LT(i, time_.size());
  FindPiece(i);
  const double t = time_[i];
  const double slack = kRounding * width_;
  const double begin = time_[piece_begin_], end = time_[piece_end_ - 1];
  double from = t - 0.5 * width_, to = t + 0.5 * width_;
  is_centred_ = from >= begin - slack && to <= end + slack;
  if (from < begin) {
    from = begin;
    to = std::min(begin + width_, end);
  } else if (to > end) {
    from = std::max(end - width_, begin);
    to = end;
  }
  centre_ = 0.5 * (from + to);
  while (first_ > piece_begin_ && time_[first_ - 1] >= from - slack) --first_;
  while (time_[first_] < from - slack) ++first_;
  past_last_ = std::max(past_last_, first_);
  while (past_last_ < piece_end_ && time_[past_last_] <= to + slack) ++past_last_;
  while (past_last_ > first_ && time_[past_last_ - 1] > to + slack) --past_last_;
}

}  // namespace fathom
