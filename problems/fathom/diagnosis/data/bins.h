// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/noise/noise_model.h"
#include "fathom/simulate/effect_simulation.h"

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// How long bins may be [s]: 0.2; up to 0.5 on long segments, and where that loses less than a
// hundredth more of the motion's variance and leaves 750.
double BinWidthFor(std::span<const MeasuredSegment> segments);

// Samples averaged over short bins, so that what follows costs little: a row for each bin.
class Bins {
 public:
  // Never across a gap.
  explicit Bins(std::span<const MeasuredSegment> segments);

  int size() const { return static_cast<int>(samples_.size()); }
  const std::vector<NoiseSample>& samples() const { return samples_; }

  // Rows of segment `index`: from first_row(index) up to first_row(index + 1).
  int first_row(std::size_t index) const { return first_rows_[index]; }

  // Means over the bins of segment `index` of something sampled at its stamps; `to` has the
  // segment's rows. For a matrix: column by column, into the given columns.
  void Average(std::size_t index,
               const std::vector<double>& velocity,
               const std::vector<double>& displacement,
               std::span<double> to) const;
  void Average(std::size_t index,
               const SensitivityMatrix& velocity,
               const SensitivityMatrix& displacement,
               Eigen::Ref<SensitivityMatrix> to) const;

 private:
  struct Bin {
    NoiseChannel channel;
    std::size_t begin, end;  // of the channel's samples
  };
  std::vector<Bin> bins_;
  std::vector<NoiseSample> samples_;
  std::vector<int> first_rows_;
};

}  // namespace fathom
