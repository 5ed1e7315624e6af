// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/folds.h"

#include <algorithm>
#include <cstddef>

namespace fathom {
namespace {

constexpr std::size_t kNumFolds = 4;

// A segment in `num` parts of the same length.
std::vector<CoupledSegment> Parts(const CoupledSegment& segment, std::size_t num) {
  std::vector<CoupledSegment> parts;
  const double length = (segment.time.back() - segment.time.front()) / static_cast<double>(num);
  for (const SampleWindow& range : WindowsOf(segment, length)) {
    CoupledSegment& part = parts.emplace_back();
    const auto cut = [](const auto& all, std::size_t begin, std::size_t end) {
      return std::vector(all.begin() + static_cast<std::ptrdiff_t>(begin),
                         all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    part.time = cut(segment.time, range.begin, range.end);
    part.velocity = cut(segment.velocity, range.begin, range.end);
    part.is_held_out = segment.is_held_out;
    if (segment.pose_time.empty()) continue;
    const auto first = segment.pose_time.begin();
    const auto from = std::lower_bound(first, segment.pose_time.end(), part.time.front()) - first;
    const auto to = std::upper_bound(first, segment.pose_time.end(), part.time.back()) - first;
    part.pose_time =
        cut(segment.pose_time, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    part.position =
        cut(segment.position, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    if (!segment.attitude.empty()) {
      part.attitude =
          cut(segment.attitude, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    }
  }
  return parts;
}

// The log with no segment of its motion.
CoupledData Emptied(const CoupledData& log) {
  CoupledData empty = log;
  empty.segments.clear();
  return empty;
}

}  // namespace

std::vector<Fold> FoldsOf(std::span<const CoupledData> logs) {
  // Of few logs one may be all that drives some DOF.
  const bool is_by_log = logs.size() >= kNumFolds;
  std::vector<Fold> folds(kNumFolds);
  for (std::size_t f = 0; f < kNumFolds; ++f) {
    for (std::size_t k = 0; k < logs.size(); ++k) {
      folds[f].train.push_back(Emptied(logs[k]));
      folds[f].unseen.push_back(Emptied(logs[k]));
      for (const CoupledSegment& segment : logs[k].segments) {
        if (segment.is_held_out) continue;
        if (is_by_log) {
          (k % kNumFolds == f ? folds[f].unseen : folds[f].train)
              .back()
              .segments.push_back(segment);
          continue;
        }
        const std::vector<CoupledSegment> parts = Parts(segment, kNumFolds);
        for (std::size_t p = 0; p < parts.size(); ++p) {
          (p % kNumFolds == f ? folds[f].unseen : folds[f].train)
              .back()
              .segments.push_back(parts[p]);
        }
      }
    }
    const auto is_empty = [](const CoupledData& log) { return log.segments.empty(); };
    std::erase_if(folds[f].train, is_empty);
    std::erase_if(folds[f].unseen, is_empty);
  }
  std::erase_if(folds, [](const Fold& fold) { return fold.train.empty() || fold.unseen.empty(); });
  return folds;
}

}  // namespace fathom
