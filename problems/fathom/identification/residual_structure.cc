// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/residual_structure.h"

#include "fathom/base/median.h"
#include "fathom/simulate/free_run.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr double kLongestLag = 30.0;                                // [s]
constexpr std::size_t kMostLags = 600;                              // at a high rate fewer seconds
constexpr std::size_t kShortestWindow = 16, kLongestWindow = 4096;  // [samples]
constexpr std::size_t kFewestWindows = 5;  // so many that do not overlap, of all data

using Columns = std::vector<std::vector<double>>;

// Residual, command and steps of the segments that can be simulated.
struct Residuals {
  Columns velocity, command;
  std::vector<double> steps;
};

Residuals ResidualsOf(const ExtendedModel& model, const Signals& scored) {
  Residuals all;
  for (const auto* segments : {&scored.train, &scored.held_out}) {
    for (const Segment& segment : *segments) {
      const auto run = FreeRunOver(segment, model);
      if (!run) continue;
      std::vector<double>& residual = all.velocity.emplace_back();
      for (std::size_t i = 0; i < run->measured.size(); ++i) {
        residual.push_back(run->measured[i] - run->predicted[i]);
      }
      all.command.push_back(segment.command.At(segment.time));
      for (std::size_t i = 1; i < segment.time.size(); ++i) {
        all.steps.push_back(segment.time[i] - segment.time[i - 1]);
      }
    }
  }
  return all;
}

std::size_t NumSamples(const Columns& columns) {
  std::size_t sum = 0;
  for (const std::vector<double>& column : columns) sum += column.size();
  return sum;
}

// A power of two: the longest that some segment holds and all data hold five times.
std::size_t WindowFor(const Columns& columns) {
  std::size_t longest = 0;
  for (const std::vector<double>& column : columns) longest = std::max(longest, column.size());
  const std::size_t most =
      std::min({longest, NumSamples(columns) / kFewestWindows, kLongestWindow});
  return std::max(std::bit_floor(most), kShortestWindow);
}

void TakeOffTheMean(Columns* columns) {
  double sum = 0.0;
  for (const auto& column : *columns) sum = std::accumulate(column.begin(), column.end(), sum);
  const double mean = sum / static_cast<double>(NumSamples(*columns));
  for (std::vector<double>& column : *columns) {
    for (double& value : column) value -= mean;
  }
}

// From the line that brings the power past 5 % to the one that brings it to 95 %, each half a step
// wide to either side.
std::optional<TimeInterval> BandOf(const Spectrum& spectrum) {
  const double power = std::accumulate(spectrum.density.begin(), spectrum.density.end(), 0.0);
  if (!(power > 0.0)) return std::nullopt;
  const double half_step = 0.5 * spectrum.frequency.front();
  TimeInterval band = {0.0, spectrum.frequency.back() + half_step};
  double sum = 0.0;
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    const double before = sum;
    sum += spectrum.density[k];
    if (before < 0.05 * power && sum >= 0.05 * power) band.from = spectrum.frequency[k] - half_step;
    if (before < 0.95 * power && sum >= 0.95 * power) band.to = spectrum.frequency[k] + half_step;
  }
  return band;
}

}  // namespace

ResidualStructure StructureOfResidual(const ExtendedModel& model, const Signals& scored) {
  Residuals residuals = ResidualsOf(model, scored);
  ResidualStructure structure;
  if (residuals.steps.empty()) return structure;
  const double step = Median(residuals.steps);
  const auto most_lags = std::min(kMostLags, static_cast<std::size_t>(kLongestLag / step));
  structure.autocorrelation = AutocorrelationOf(residuals.velocity, step, most_lags);
  if (structure.autocorrelation.lag.empty()) return structure;
  const std::size_t window = WindowFor(residuals.velocity);
  structure.spectrum = SpectrumOf(residuals.velocity, step, window);
  TakeOffTheMean(&residuals.command);
  structure.excited = BandOf(SpectrumOf(residuals.command, step, window));
  return structure;
}

double ShareOutside(const Autocorrelation& autocorrelation) {
  const std::size_t count = autocorrelation.lag.size();
  double outside = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    if (std::abs(autocorrelation.value[k]) > autocorrelation.bound[k]) outside += 1.0;
  }
  return outside / static_cast<double>(count);
}

PowerShares SharesAbout(const TimeInterval& band, const Spectrum& spectrum) {
  PowerShares shares;
  double sum = 0.0;
  for (std::size_t k = 0; k < spectrum.frequency.size(); ++k) {
    const double frequency = spectrum.frequency[k];
    double& share = frequency < band.from ? shares.below
                    : frequency < band.to ? shares.within
                                          : shares.above;
    share += spectrum.density[k];
    sum += spectrum.density[k];
  }
  return {shares.below / sum, shares.within / sum, shares.above / sum};
}

double WhiteShareWithin(const TimeInterval& band, const Spectrum& spectrum) {
  Spectrum white = spectrum;
  white.density.assign(white.frequency.size(), 1.0);
  return SharesAbout(band, white).within;
}

}  // namespace fathom
