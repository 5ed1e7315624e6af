// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/bins.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fathom {
namespace {

// The mean of some variances as a power of two, so that there are few.
double Rounded(std::span<const double> variances) {
  double sum = 0.0;
  for (const double variance : variances) sum += variance;
  return std::exp2(std::round(std::log2(sum / static_cast<double>(variances.size()))));
}

}  // namespace

Bins::Bins(std::span<const MeasuredSegment> segments) {
  for (size_t index = 0; index < segments.size(); ++index) {
    const MeasuredSegment& segment = segments[index];
    first_rows_.push_back(size());
    const double width = std::clamp(segment.duration() / 3000.0, 0.2, 0.5);
    struct Row {
      double time;
      Bin bin;
    };
    std::vector<Row> rows;
    const auto add = [&](const std::vector<double>& time, NoiseChannel channel) {
      for (size_t begin = 0; begin < time.size();) {
        size_t end = begin + 1;
        double sum = time[begin];
        while (end < time.size() && time[end] - time[begin] < width - 1e-6) sum += time[end++];
        rows.push_back({sum / static_cast<double>(end - begin), {channel, begin, end}});
        begin = end;
      }
    };
    add(segment.stamps.velocity, NoiseChannel::kVelocity);
    add(segment.stamps.displacement, NoiseChannel::kDisplacement);
    std::stable_sort(
        rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.time < b.time; });
    std::array<std::vector<double>, 2> counts;
    for (const Row& row : rows) {
      counts[static_cast<size_t>(row.bin.channel)].push_back(
          static_cast<double>(row.bin.end - row.bin.begin));
    }
    std::array<double, 2> usual = {1.0, 1.0};
    for (size_t channel = 0; channel < 2; ++channel) {
      if (!counts[channel].empty()) usual[channel] = Median(counts[channel]);
    }
    const std::span<const double> variances = segment.displacement_variance;
    for (const Row& row : rows) {
      const std::size_t count = row.bin.end - row.bin.begin;
      const bool is_uneven = row.bin.channel == NoiseChannel::kDisplacement && !variances.empty();
      const double uneven = is_uneven ? Rounded(variances.subspan(row.bin.begin, count)) : 1.0;
      const double of_mean =
          usual[static_cast<size_t>(row.bin.channel)] / static_cast<double>(count);
      bins_.push_back(row.bin);
      samples_.push_back({row.time, row.bin.channel, uneven * of_mean, static_cast<int>(index)});
    }
  }
  first_rows_.push_back(size());
}

void Bins::Average(std::size_t index,
                   const std::vector<double>& velocity,
                   const std::vector<double>& displacement,
                   std::span<double> to) const {
  for (int row = first_row(index); row < first_row(index + 1); ++row) {
    const Bin& bin = bins_[row];
    const auto& from = bin.channel == NoiseChannel::kVelocity ? velocity : displacement;
    double sum = 0.0;
    for (size_t i = bin.begin; i < bin.end; ++i) sum += from[i];
    to[row - first_row(index)] = sum / static_cast<double>(bin.end - bin.begin);
  }
}

void Bins::Average(std::size_t index,
                   const SensitivityMatrix& velocity,
                   const SensitivityMatrix& displacement,
                   Eigen::Ref<SensitivityMatrix> to) const {
  for (int row = first_row(index); row < first_row(index + 1); ++row) {
    const Bin& bin = bins_[row];
    const auto& from = bin.channel == NoiseChannel::kVelocity ? velocity : displacement;
    to.row(row - first_row(index)) = from.middleRows(static_cast<Eigen::Index>(bin.begin),
                                                     static_cast<Eigen::Index>(bin.end - bin.begin))
                                         .colwise()
                                         .mean();
  }
}

}  // namespace fathom
