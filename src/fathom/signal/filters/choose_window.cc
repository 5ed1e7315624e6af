// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/choose_window.h"

#include "fathom/signal/filters/normal_equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr std::size_t kMostScored = 500;      // stamps that are predicted
constexpr double kTolerance = 1.01;           // of the best score
constexpr double kLeftOut = 0.26;             // of the shortest window, on either side of a sample
constexpr double kNothingButRounding = 1e-8;  // of the normal equations: nothing but rounding
constexpr double kMostLeverage = 999.0;       // variance of a prediction over that of a sample

// Windows about one sample, each wider than the one before, and what they predict of it.
class NestedFits {
 public:
  // `time` and `values` must outlive this. `reach` [s] is half of the widest window.
  NestedFits(std::span<const double> time,
             std::span<const double> values,
             int order,
             double left_out,
             double reach)
      : time_(time),
        values_(values),
        order_(order),
        left_out_(left_out),
        reach_(reach),
        equations_(order) {}

  // To sample `i`, with no window about it yet.
  void MoveTo(std::size_t i) {
    own_ = i;
    first_ = past_last_ = i;
    sums_.fill(0.0);
    value_sums_.fill(0.0);
    while (first_ > 0 && time_[own_] - time_[first_ - 1] <= left_out_) --first_;
    while (past_last_ < time_.size() && time_[past_last_] - time_[own_] <= left_out_) ++past_last_;
  }

  // Widens the window to this half width [s]. NaN where it holds too few samples or a silence
  // shifts it.
  double Predict(double half_width) {
    while (first_ > 0 && IsWithin(first_ - 1, half_width)) Count(--first_);
    while (past_last_ < time_.size() && IsWithin(past_last_, half_width)) Count(past_last_++);
    if (!IsCentred(half_width)) return kNaN;
    if (!equations_.Factorize([this](int k, int l) { return sums_[k + l]; }, kNothingButRounding))
      return kNaN;
    NormalEquations::Coefficients weights = {1.0};  // the prediction is its product with the sums
    equations_.Solve(&weights);
    if (weights[0] > kMostLeverage) return kNaN;
    double prediction = values_[own_];
    for (int k = 0; k <= order_; ++k) prediction += weights[k] * value_sums_[k];
    return prediction;
  }

 private:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kRounding = 1.0 + 2e-6;  // of stamps at a window's edge

  bool IsWithin(std::size_t sample, double half_width) const {
    return std::abs(time_[sample] - time_[own_]) <= kRounding * half_width;
  }

  // Whether neither side ends at a silence, which a window does not bridge.
  bool IsCentred(double half_width) const {
    const auto reaches_to = [&](std::size_t last, std::size_t next) {
      if (std::abs(time_[last] - time_[own_]) * kRounding >= half_width) return true;
      return next < time_.size() && std::abs(time_[next] - time_[last]) <= kRounding * half_width;
    };
    return reaches_to(first_, first_ - 1) && reaches_to(past_last_ - 1, past_last_);
  }

  void Count(std::size_t sample) {
    const double x = (time_[sample] - time_[own_]) / reach_;
    const double y = values_[sample] - values_[own_];
    double power = 1.0;
    for (int k = 0; k <= order_; ++k, power *= x) {
      sums_[k] += power;
      value_sums_[k] += power * y;
    }
    for (int k = order_ + 1; k <= 2 * order_; ++k, power *= x) sums_[k] += power;
  }

  std::span<const double> time_, values_;
  int order_;
  double left_out_, reach_;
  std::size_t own_ = 0, first_ = 0, past_last_ = 0;
  std::array<double, 2 * kHighestOrder + 1> sums_ = {};  // of powers of (t - t_own) / reach
  NormalEquations::Coefficients value_sums_ = {};        // of powers times y - y_own
  NormalEquations equations_;
};

struct Score {
  double sum = 0.0, count = 0.0;

  double Mean() const { return sum / count; }
};

// Of each window, over stamps that are all well inside the data.
std::vector<Score> ScoresOf(const std::vector<double>& windows,
                            std::span<const double> time,
                            std::span<const double> values,
                            int order) {
  const double reach = 0.5 * windows.back();
  const auto lower_bound = [&](double t) -> std::size_t {
    return std::lower_bound(time.begin(), time.end(), t) - time.begin();
  };
  const std::size_t begin = lower_bound(time.front() + reach);
  const std::size_t end = lower_bound(time.back() - reach);
  const std::size_t stride = 1 + (end - std::min(begin, end)) / kMostScored;
  std::vector<Score> scores(windows.size());
  NestedFits fits(time, values, order, kLeftOut * windows.front(), reach);
  for (std::size_t i = begin; i < end; i += stride) {
    fits.MoveTo(i);
    for (std::size_t k = 0; k < windows.size(); ++k) {
      const double error = std::abs(fits.Predict(0.5 * windows[k]) - values[i]);
      if (!std::isfinite(error)) continue;
      scores[k].sum += error;
      scores[k].count += 1.0;
    }
  }
  return scores;
}

}  // namespace

double ChooseWindow(std::span<const double> time,
                    std::span<const double> values,
                    int order,
                    double shortest,
                    double longest) {
  CHECK_EQ(time.size(), values.size());
  std::vector<double> windows;
  for (double window = shortest; window <= longest; window *= std::numbers::sqrt2) {
    windows.push_back(window);
  }
  if (windows.size() < 2) return shortest;
  const std::vector<Score> scores = ScoresOf(windows, time, values, order);
  double most = 0.0;
  for (const Score& score : scores) most = std::max(most, score.count);
  const auto is_scored = [&](const Score& score) { return score.count > 0.5 * most; };
  double best = std::numeric_limits<double>::infinity();
  for (const Score& score : scores) {
    if (is_scored(score)) best = std::min(best, score.Mean());
  }
  for (std::size_t k = 0; k < windows.size(); ++k) {
    if (is_scored(scores[k]) && scores[k].Mean() <= kTolerance * best) return windows[k];
  }
  return shortest;
}

}  // namespace fathom
