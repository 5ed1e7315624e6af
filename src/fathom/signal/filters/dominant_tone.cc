// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/dominant_tone.h"

#include "fathom/signal/filters/integral.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMostBins = 2048;

// The command's means over equal bins, less their mean.
struct Bins {
  double width = 0.0;  // [s]
  Eigen::VectorXd value;
};

Bins BinsOf(const HeldCommand& command, double duration) {
  const int n = std::clamp(static_cast<int>(2 * command.time.size()), 16, kMostBins);
  Bins bins;
  bins.width = duration / n;
  std::vector<double> edges(n + 1);
  for (int i = 0; i <= n; ++i) edges[i] = command.time.front() + i * bins.width;
  const std::vector<double> integral = IntegralsOf(command, edges).once;
  bins.value.resize(n);
  for (int i = 0; i < n; ++i) bins.value[i] = (integral[i + 1] - integral[i]) / bins.width;
  bins.value.array() -= bins.value.mean();
  return bins;
}

// Frequencies that are looked at side by side.
constexpr int kWidth = 8;
using Row = Eigen::Array<double, kWidth, 1>;

// Shares of the sum of squares that a constant and a sine of each of the frequencies explain.
Row SharesAt(const Bins& bins, const Row& frequencies) {
  const Row step_c = (frequencies * bins.width).cos(), step_s = (frequencies * bins.width).sin();
  Row re = Row::Ones(), im = Row::Zero();  // of the phase
  Row c = im, s = im, cc = im, cs = im, ss = im, yc = im, ys = im;
  for (const double y : bins.value) {
    c += re;
    s += im;
    cc += re * re;
    cs += re * im;
    ss += im * im;
    yc += y * re;
    ys += y * im;
    const Row turned = re * step_c - im * step_s;
    im = re * step_s + im * step_c;
    re = turned;
  }
  const auto n = static_cast<double>(bins.value.size());
  // The values have mean 0.
  const Row a = cc - c * c / n, b = cs - c * s / n, d = ss - s * s / n;
  return (d * yc * yc - 2.0 * b * yc * ys + a * ys * ys) / (a * d - b * b) /
         bins.value.squaredNorm();
}

double ShareAt(const Bins& bins, double frequency) {
  return SharesAt(bins, Row::Constant(frequency))[0];
}

}  // namespace

Tone DominantTone(const HeldCommand& command, double duration) {
  CHECK(!command.time.empty());
  CHECK_GT(duration, 0.0);
  const auto [least, most] = std::minmax_element(command.value.begin(), command.value.end());
  if (*least == *most) return {};
  const Bins bins = BinsOf(command, duration);
  if (!(bins.value.squaredNorm() > 0.0)) return {};

  const double step = 0.5 * kPi / duration;
  const double highest = 0.5 * kPi / bins.width;
  Tone tone = {2.0 * step, 0.0};
  for (double first = 2.0 * step; first < highest; first += kWidth * step) {
    const Row frequencies = first + step * Row::LinSpaced(kWidth, 0.0, kWidth - 1.0);
    const Row shares = SharesAt(bins, frequencies);
    for (int i = 0; i < kWidth && frequencies[i] < highest; ++i) {
      if (shares[i] > tone.share) tone = {frequencies[i], shares[i]};
    }
  }
  // Golden section between the neighbours on the grid.
  double from = tone.frequency - step, to = tone.frequency + step;
  const double ratio = 1.0 / std::numbers::phi;
  while (to - from > 1e-4 * step) {
    const double a = to - ratio * (to - from), b = from + ratio * (to - from);
    if (ShareAt(bins, a) > ShareAt(bins, b)) {
      to = b;
    } else {
      from = a;
    }
  }
  tone.frequency = 0.5 * (from + to);
  tone.share = std::clamp(ShareAt(bins, tone.frequency), 0.0, 1.0);
  return tone;
}

Tone DominantTone(const HeldCommand& command) {
  const double duration = command.time.empty() ? 0.0 : command.time.back() - command.time.front();
  return duration > 0.0 ? DominantTone(command, duration) : Tone{};
}

}  // namespace fathom
