// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>

namespace fathom {

// Which samples a filter of width w takes at each stamp:
//
//   [t_i - w/2, t_i + w/2], shifted inwards where it would reach beyond the data
//
// A silence of more than half the width counts as an end of the data: it is never bridged.
class MovingWindow {
 public:
  // `time` [s] strictly increasing, which must outlive this; `width` [s] above 0.
  MovingWindow(std::span<const double> time, double width);

  // To stamp `i`. Quickest in rising order of `i`.
  void MoveTo(std::size_t i);

  // At the stamp last moved to: samples first() to past_last() - 1.
  std::size_t first() const { return first_; }
  std::size_t past_last() const { return past_last_; }
  std::size_t size() const { return past_last_ - first_; }

  // The middle of the window [s].
  double centre() const { return centre_; }

  // False if the window is shifted: the stamp is closer than half a window to an end of the data.
  bool is_centred() const { return is_centred_; }

 private:
  void FindPiece(std::size_t i);

  std::span<const double> time_;
  double width_;
  std::size_t piece_begin_ = 0, piece_end_ = 0;  // between two silences
  std::size_t first_ = 0, past_last_ = 0;
  double centre_ = 0.0;
  bool is_centred_ = false;
};

}  // namespace fathom
