// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/series.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

bool IsKnown(const DiveEstimate& estimate, int parameter) {
  const double variance = estimate.covariance(parameter, parameter);
  return std::isfinite(estimate.value(parameter)) && std::isfinite(variance) && variance > 0.0;
}

DiveSeries Standardised(Dof dof,
                        int parameter,
                        std::span<const DiveEstimate> estimates,
                        std::vector<int> members) {
  std::stable_sort(members.begin(), members.end(), [&](int a, int b) {
    return estimates[a].dive < estimates[b].dive;
  });
  std::vector<double> deviations;
  for (const int member : members) {
    deviations.push_back(std::sqrt(estimates[member].covariance(parameter, parameter)));
  }
  DiveSeries series{dof, parameter, {}, members, Median(deviations), {}, {}};
  const Eigen::Index size = static_cast<Eigen::Index>(members.size());
  series.value.resize(size);
  series.variance.resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const DiveEstimate& estimate = estimates[members[i]];
    series.dive.push_back(estimate.dive);
    series.value(i) = estimate.value(parameter) / series.scale;
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
      covariance(i, j) = estimate.covariance(a.parameter, b.parameter) / (a.scale * b.scale);
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
  std::vector<DiveSeries> all;
  for (const Dof dof : kAllDofs) {
    for (int parameter = 0; parameter < kNumParameters; ++parameter) {
      std::vector<int> members;
      for (int i = 0; i < static_cast<int>(estimates.size()); ++i) {
        const DiveEstimate& estimate = estimates[i];
        const bool has_place = estimate.dive >= 0 && estimate.dive < num_dives;
        if (estimate.dof == dof && has_place && IsKnown(estimate, parameter)) members.push_back(i);
      }
      if (static_cast<int>(members.size()) < std::max(least_dives, 1)) continue;
      all.push_back(Standardised(dof, parameter, estimates, members));
    }
  }
  return all;
}

DiveSeries WithoutElement(const DiveSeries& series, int index) {
  DiveSeries rest = series;
  rest.dive.erase(rest.dive.begin() + index);
  rest.estimate.erase(rest.estimate.begin() + index);
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
