// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/run_noise.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/base/robust_std.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr double kCutOff = 3.0;  // robust standard deviations

std::vector<double> ResidualOf(const ComparedSegment& run, bool is_position) {
  const std::vector<double>& measured = is_position ? run.segment->position : run.segment->velocity;
  using Column = Eigen::Map<const Eigen::VectorXd>;
  const auto size = static_cast<Eigen::Index>(measured.size());
  Eigen::VectorXd residual = Column(measured.data(), size) - Column(run.simulated.data(), size);
  residual -= *run.by_start * PivotedQr(*run.by_start).Solve(residual);
  return {residual.data(), residual.data() + residual.size()};
}

// The same noise, a little shorter in memory: of a colour that does not die away by itself.
std::vector<double> Damped(std::vector<double> coefficients) {
  constexpr double kDamping = 0.999;  // of each sample
  double factor = 1.0;
  for (double& phi : coefficients) phi *= factor *= kDamping;
  return coefficients;
}

}  // namespace

double RunNoise::NeighbourCorrelation() const {
  return CorrelationsOf(noise.colour.coefficients, 2)[1];
}

std::vector<SampleRange> UnbrokenRanges(std::span<const double> time) {
  return SplitAtGaps({time.begin(), time.end()}, {}, 0, 1.8 * MedianStep(time));
}

RunNoise NoiseOfRuns(std::span<const ComparedSegment> runs, bool is_position) {
  std::vector<std::vector<double>> residuals;
  std::vector<double> sizes;
  for (const ComparedSegment& run : runs) {
    const std::vector<double> residual = ResidualOf(run, is_position);
    for (const double miss : residual) sizes.push_back(std::abs(miss));
    for (const SampleRange& range : UnbrokenRanges(run.segment->time)) {
      residuals.emplace_back(residual.begin() + static_cast<std::ptrdiff_t>(range.begin),
                             residual.begin() + static_cast<std::ptrdiff_t>(range.end));
    }
  }
  const auto count = static_cast<double>(sizes.size());
  const double most = kCutOff * RobustStd(std::move(sizes));
  double squares = 0.0;
  for (std::vector<double>& residual : residuals) {
    for (double& miss : residual) {
      miss = std::clamp(miss, -most, most);
      squares += miss * miss;
    }
  }
  const int max_order = static_cast<int>(std::min({60.0, 10.0 * std::log10(count), count / 10.0}));
  Autoregression colour = FitAutoregression(std::move(residuals), max_order);
  const double size = std::sqrt(squares / count);
  try {
    return {is_position, MeansOf(size, colour.coefficients, 1)};
  } catch (const InputError&) {
    return {is_position, MeansOf(size, Damped(std::move(colour.coefficients)), 1)};
  }
}

}  // namespace fathom
