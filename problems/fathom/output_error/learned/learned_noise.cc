// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/learned_noise.h"

#include "fathom/noise/damping_factors.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fathom {
namespace {

double UsualSpeed(std::span<const BinnedSegment> bins) {
  double sum = 0.0, n = 0.0;
  for (const BinnedSegment& part : bins) {
    for (const double v : part.segment->velocity) sum += std::abs(v);
    n += static_cast<double>(part.segment->velocity.size());
  }
  return sum / n;
}

}  // namespace

NoiseFit LearnNoise(std::span<const BinnedSegment> bins,
                    std::span<const BinnedRun> runs,
                    const UncoupledModel<double>& model,
                    const OffsetSharing& offsets,
                    const std::optional<NoiseModel>& start) {
  constexpr double kLeastRate = 1e-3;  // [1/s]
  constexpr double kPrecision = 0.005;
  const int state_size = StateSize(runs[0].output);
  Eigen::Index num_rows = 0;
  for (const BinnedRun& run : runs) num_rows += run.columns.rows();
  const auto num_shared = static_cast<Eigen::Index>(kBuoyancy + offsets.Count());
  RowMajorMatrix design = RowMajorMatrix::Zero(
      num_rows, num_shared + state_size * static_cast<Eigen::Index>(runs.size()));
  std::vector<NoiseSample> samples;
  std::vector<double> residual;
  Eigen::Index row = 0, column = num_shared;
  for (size_t s = 0; s < runs.size(); ++s) {
    const Eigen::Index n = runs[s].columns.rows();
    const auto offset = static_cast<Eigen::Index>(kBuoyancy + offsets.At(s));
    design.block(row, 0, n, kBuoyancy) = runs[s].parameters().leftCols(kBuoyancy);
    design.block(row, offset, n, 1) = runs[s].parameters().col(kBuoyancy);
    design.block(row, column, n, state_size) = runs[s].state();
    for (NoiseSample sample : bins[s].samples) {
      sample.segment = static_cast<int>(s);
      samples.push_back(sample);
    }
    for (const double r : runs[s].residual()) residual.push_back(r);
    row += n;
    column += state_size;
  }
  FitNoiseOptions options;
  options.damping_rate = std::max(kLeastRate, model.DampingSlope(UsualSpeed(bins)) / model.inertia);
  options.precision = kPrecision;
  options.start = start;
  return FitNoise(samples, residual, design, options);
}

void SetDampingFactors(const UncoupledModel<double>& model, std::span<BinnedSegment> bins) {
  const double usual = model.DampingSlope(UsualSpeed(bins));
  for (BinnedSegment& part : bins) {
    std::vector<double> damping;
    damping.reserve(part.segment->velocity.size());
    for (const double v : part.segment->velocity) damping.push_back(model.DampingSlope(v));
    SetDampingFactors(part.segment->time, damping, usual, part.samples);
  }
}

}  // namespace fathom
