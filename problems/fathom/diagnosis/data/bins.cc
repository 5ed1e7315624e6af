// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/bins.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace fathom {
namespace {

constexpr double kShortest = 0.2, kLongest = 0.5;  // [s]
constexpr double kMostBins = 3000.0;               // of a segment, unless they get too long
constexpr double kLeastBins = 750.0;               // of all segments
constexpr double kMostLost = 0.01;                 // of the variance of the speed

// A mean over a bin has no sharper time than this, of its width. Few intervals that differ make the
// noise's filter quick.
constexpr double kGrain = 1.0 / 16.0;

// The mean of some variances as a power of two, so that there are few.
double Rounded(std::span<const double> variances) {
  double sum = 0.0;
  for (const double variance : variances) sum += variance;
  return std::exp2(std::round(std::log2(sum / static_cast<double>(variances.size()))));
}

// Share of the variance of the speed that means over bins of a width lose.
double LostTo(double width, std::span<const Segment> segments) {
  double lost = 0.0, all = 0.0;
  for (const Segment& segment : segments) {
    const std::vector<double>& t = segment.time;
    const Eigen::Map<const Eigen::ArrayXd> v(segment.velocity.data(), std::ssize(t));
    all += (v - v.mean()).square().sum();
    for (std::size_t begin = 0, end = 0; begin < t.size(); begin = end) {
      while (end < t.size() && t[end] - t[begin] < width) ++end;
      const auto own =
          v.segment(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin));
      lost += (own - own.mean()).square().sum();
    }
  }
  return all > 0.0 ? lost / all : 1.0;
}

}  // namespace

// The longest that lose little more than the shortest and leave many.
double BinWidthFor(std::span<const MeasuredSegment> segments) {
  std::vector<Segment> plain;
  double duration = 0.0;
  for (const MeasuredSegment& segment : segments) {
    duration += segment.duration();
    plain.push_back(PlainSegment(segment));
    if (plain.back().time.empty()) plain.pop_back();
  }
  const double most = LostTo(kShortest, plain) + kMostLost;
  double width = std::min(kLongest, duration / kLeastBins);
  while (width > kShortest && LostTo(width, plain) > most) width -= 0.1;
  return std::max(width, kShortest);
}

Bins::Bins(std::span<const MeasuredSegment> segments) {
  const double width_of_motion = BinWidthFor(segments);
  for (size_t index = 0; index < segments.size(); ++index) {
    const MeasuredSegment& segment = segments[index];
    first_rows_.push_back(size());
    const double width = std::clamp(segment.duration() / kMostBins, width_of_motion, kLongest);
    const double grain = kGrain * width;
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
        const double middle = sum / static_cast<double>(end - begin) - segment.stamps.start;
        rows.push_back(
            {segment.stamps.start + grain * std::round(middle / grain), {channel, begin, end}});
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
