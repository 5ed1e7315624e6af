// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/dominant_tone.h"

#include "fathom/signal/filters/integral.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <glog/logging.h>
#include <unsupported/Eigen/FFT>

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

// The sum of exp(i phase k) over n terms from k = 0.
std::complex<double> PhasorSum(double phase, double n) {
  // Its length below 0 as well, which std::polar() does not take.
  const double length = std::sin(0.5 * n * phase) / std::sin(0.5 * phase);
  return length * std::polar(1.0, 0.5 * (n - 1.0) * phase);
}

// The sum of each bin's value times exp(i phase k).
std::complex<double> ProjectionAt(const Bins& bins, double phase) {
  const std::complex<double> step = std::polar(1.0, phase);
  std::complex<double> turned = 1.0, sum = 0.0;
  for (const double value : bins.value) {
    sum += value * turned;
    turned *= step;
  }
  return sum;
}

// Share of the sum of squares that a constant and a sine explain, (9). The sine turns by `phase`
// from bin to bin, between 0 and pi / 2 [rad].
double ShareOf(const Bins& bins, double phase, std::complex<double> projection) {
  const auto n = static_cast<double>(bins.value.size());
  const std::complex<double> once = PhasorSum(phase, n), twice = PhasorSum(2.0 * phase, n);
  // The normal equations of cosine and sine, less their means: the values have mean 0.
  const double a = 0.5 * (n + twice.real()) - once.real() * once.real() / n;
  const double b = 0.5 * twice.imag() - once.real() * once.imag() / n;
  const double d = 0.5 * (n - twice.real()) - once.imag() * once.imag() / n;
  const double c = projection.real(), s = projection.imag();
  return (d * c * c - 2.0 * b * c * s + a * s * s) / (a * d - b * b) / bins.value.squaredNorm();
}

double ShareAt(const Bins& bins, double phase) {
  return ShareOf(bins, phase, ProjectionAt(bins, phase));
}

}  // namespace

Tone DominantTone(const HeldCommand& command, double duration) {
  CHECK(!command.time.empty());
  CHECK_GT(duration, 0.0);
  const auto [least, most] = std::minmax_element(command.value.begin(), command.value.end());
  if (*least == *most) return {};
  const Bins bins = BinsOf(command, duration);
  if (!(bins.value.squaredNorm() > 0.0)) return {};

  // Zeros up to four times the length put the transform's lines at most a quarter of a period
  // apart; one of a power of two is quick.
  const Eigen::Index n = bins.value.size();
  const auto length = static_cast<Eigen::Index>(std::bit_ceil(static_cast<std::size_t>(4 * n)));
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(length);
  padded.head(n) = bins.value;
  Eigen::VectorXcd lines;
  Eigen::FFT<double>().fwd(lines, padded);
  const double step = 2.0 * kPi / static_cast<double>(length);  // in phase a bin
  const Eigen::Index first = (length + 2 * n - 1) / (2 * n);    // half a period in all
  double best = static_cast<double>(first) * step, share = 0.0;
  for (Eigen::Index k = first; k < length / 4; ++k) {
    const double phase = static_cast<double>(k) * step;
    const double of_line = ShareOf(bins, phase, std::conj(lines[k]));
    if (of_line > share) {
      best = phase;
      share = of_line;
    }
  }
  // Golden section between the neighbours on the grid.
  double from = best - step, to = best + step;
  const double ratio = 1.0 / std::numbers::phi;
  while (to - from > 1e-4 * step) {
    const double a = to - ratio * (to - from), b = from + ratio * (to - from);
    if (ShareAt(bins, a) > ShareAt(bins, b)) {
      to = b;
    } else {
      from = a;
    }
  }
  const double phase = 0.5 * (from + to);
  return {phase / bins.width, std::clamp(ShareAt(bins, phase), 0.0, 1.0)};
}

Tone DominantTone(const HeldCommand& command) {
  const double duration = command.time.empty() ? 0.0 : command.time.back() - command.time.front();
  return duration > 0.0 ? DominantTone(command, duration) : Tone{};
}

}  // namespace fathom
