// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/series.h"

#include "fathom/base/median.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

// What a series is of.
struct SeriesKey {
  Dof dof = Dof::kSurge;
  int parameter = 0;
  std::optional<FreeEntry> entry = {};

  // In the order of series.
  auto Order() const {
    const int last = kNumParameters;
    return std::tuple(Index(dof),
                      parameter == kNoParameter ? last : parameter,
                      entry ? NameOf(*entry) : std::string());
  }
  bool operator<(const SeriesKey& other) const { return Order() < other.Order(); }
};

// Where an estimate stands, and which of its values is meant.
struct Member {
  int estimate = 0;
  int number = 0;
};

SeriesKey KeyOf(const DiveEstimate& estimate, int number) {
  if (estimate.entries.empty()) return {estimate.dof, number};
  const FreeEntry& entry = estimate.entries[static_cast<std::size_t>(number)];
  const bool is_heave = entry.kind == FreeEntry::Kind::kNetBuoyancy;
  return {is_heave ? Dof::kHeave : entry.row, ParameterOf(entry), entry};
}

bool IsKnown(const DiveEstimate& estimate, int number) {
  const double variance = estimate.covariance(number, number);
  return std::isfinite(estimate.value(number)) && std::isfinite(variance) && variance > 0.0;
}

DiveSeries Standardised(const SeriesKey& key,
                        std::span<const DiveEstimate> estimates,
                        std::vector<Member> members) {
  std::stable_sort(members.begin(), members.end(), [&](const Member& a, const Member& b) {
    return estimates[a.estimate].dive < estimates[b.estimate].dive;
  });
  std::vector<double> deviations;
  for (const Member& member : members) {
    const Eigen::MatrixXd& covariance = estimates[member.estimate].covariance;
    deviations.push_back(std::sqrt(covariance(member.number, member.number)));
  }
  DiveSeries series{key.dof, key.parameter, {}, {}, Median(deviations), {}, {}, key.entry};
  const Eigen::Index size = static_cast<Eigen::Index>(members.size());
  series.value.resize(size);
  series.variance.resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const DiveEstimate& estimate = estimates[members[i].estimate];
    series.dive.push_back(estimate.dive);
    series.estimate.push_back(members[i].estimate);
    series.number.push_back(members[i].number);
    series.value(i) = estimate.value(members[i].number) / series.scale;
    series.variance(i) = std::pow(deviations[i] / series.scale, 2);
  }
  return series;
}

Eigen::MatrixXd BlockCovariance(const DiveEstimate& estimate,
                                const DiveBlock& block,
                                std::span<const DiveSeries> series) {
  const Eigen::Index size = static_cast<Eigen::Index>(block.series.size());
  Eigen::MatrixXd covariance(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      const DiveSeries& a = series[block.series[i]];
      const DiveSeries& b = series[block.series[j]];
      covariance(i, j) =
          estimate.covariance(a.number[block.element[i]], b.number[block.element[j]]) /
          (a.scale * b.scale);
      if (!std::isfinite(covariance(i, j))) covariance(i, j) = 0.0;
    }
  }
  const bool is_possible = covariance.llt().info() == Eigen::Success;
  return is_possible ? covariance : Eigen::MatrixXd(covariance.diagonal().asDiagonal());
}

}  // namespace

std::vector<DiveSeries> SeriesOf(std::span<const DiveEstimate> estimates,
                                 int num_dives,
                                 int least_dives) {
  std::map<SeriesKey, std::vector<Member>> members_of;
  for (int i = 0; i < static_cast<int>(estimates.size()); ++i) {
    const DiveEstimate& estimate = estimates[i];
    if (estimate.dive < 0 || estimate.dive >= num_dives) continue;
    for (int number = 0; number < static_cast<int>(estimate.value.size()); ++number) {
      if (!IsKnown(estimate, number)) continue;
      members_of[KeyOf(estimate, number)].push_back({i, number});
    }
  }
  std::vector<DiveSeries> all;
  for (const auto& [key, members] : members_of) {
    if (static_cast<int>(members.size()) < std::max(least_dives, 1)) continue;
    all.push_back(Standardised(key, estimates, members));
  }
  return all;
}

DiveSeries WithoutElement(const DiveSeries& series, int index) {
  DiveSeries rest = series;
  rest.dive.erase(rest.dive.begin() + index);
  rest.estimate.erase(rest.estimate.begin() + index);
  rest.number.erase(rest.number.begin() + index);
  const Eigen::Index size = series.value.size() - 1;
  const Eigen::Index after = size - index;
  rest.value.segment(index, after) = series.value.tail(after);
  rest.variance.segment(index, after) = series.variance.tail(after);
  rest.value.conservativeResize(size);
  rest.variance.conservativeResize(size);
  return rest;
}

std::vector<DiveBlock> BlocksOf(std::span<const DiveEstimate> estimates,
                                std::span<const DiveSeries> series) {
  std::map<int, DiveBlock> blocks;  // by estimate
  for (int s = 0; s < static_cast<int>(series.size()); ++s) {
    for (int i = 0; i < static_cast<int>(series[s].estimate.size()); ++i) {
      DiveBlock& block = blocks[series[s].estimate[i]];
      block.series.push_back(s);
      block.element.push_back(i);
    }
  }
  std::vector<DiveBlock> result;
  for (auto& [estimate, block] : blocks) {
    block.covariance = BlockCovariance(estimates[estimate], block, series);
    result.push_back(std::move(block));
  }
  return result;
}

}  // namespace fathom
