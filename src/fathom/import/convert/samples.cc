// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/samples.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fathom {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kGapSteps = 3.0;
constexpr double kShortestGap = 0.5;  // [s]

// Keeps the rows `kept`, in this order.
void Keep(const std::vector<std::size_t>& kept, ChannelSamples* samples) {
  const auto picked = [&](const std::vector<double>& all) {
    std::vector<double> some;
    some.reserve(kept.size());
    for (const std::size_t row : kept) some.push_back(all[row]);
    return some;
  };
  samples->time = picked(samples->time);
  for (auto& column : samples->values) column = picked(column);
}

// The quaternion `share` of the way from row - 1 to row along the great circle. Its length is on a
// straight line, so that one that is no quaternion stays none.
void Slerp(const ChannelSamples& samples,
           std::size_t row,
           double share,
           std::size_t result_row,
           std::vector<std::vector<double>>* result) {
  Eigen::Vector4d from;
  Eigen::Vector4d to;
  for (int i = 0; i < 4; ++i) {
    const auto& column = samples.values[(*samples.quaternion)[i]];
    from[i] = column[row - 1];
    to[i] = column[row];
  }
  const double length = from.norm() + share * (to.norm() - from.norm());
  const Eigen::Quaterniond turned =
      Eigen::Quaterniond(from.normalized()).slerp(share, Eigen::Quaterniond(to.normalized()));
  for (int i = 0; i < 4; ++i) {
    (*result)[(*samples.quaternion)[i]][result_row] = length * turned.coeffs()[i];
  }
}

// The stamps of all channels in order. Of those of one cycle the last.
std::vector<double> StampsOfAll(const std::vector<ChannelSamples>& channels) {
  constexpr double kShareOfStep = 0.02;
  std::vector<double> all;
  double step = std::numeric_limits<double>::infinity();
  for (const ChannelSamples& channel : channels) {
    all.insert(all.end(), channel.time.begin(), channel.time.end());
    if (channel.time.size() > 1) step = std::min(step, StepOf(channel));
  }
  const double cycle = std::isfinite(step) ? kShareOfStep * step : 0.0;
  std::sort(all.begin(), all.end());
  std::vector<double> stamps;
  double begin = 0.0;  // of the cycle
  for (const double time : all) {
    if (!stamps.empty() && time - begin <= cycle) {
      stamps.back() = time;
    } else {
      stamps.push_back(time);
      begin = time;
    }
  }
  return stamps;
}

}  // namespace

LeftOutRows Clean(ChannelSamples* samples) {
  LeftOutRows left_out;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < samples->time.size(); ++row) {
    const auto num_empty =
        std::count_if(samples->values.begin(), samples->values.end(), [&](const auto& column) {
          return !std::isfinite(column[row]);
        });
    if (num_empty == 0 && std::isfinite(samples->time[row])) {
      rows.push_back(row);
    } else if (num_empty < std::ssize(samples->values)) {
      ++left_out.incomplete;
    } else {
      ++left_out.empty;
    }
  }
  const auto is_before = [&](std::size_t a, std::size_t b) {
    return samples->time[a] < samples->time[b];
  };
  double latest = -std::numeric_limits<double>::infinity();
  for (const std::size_t row : rows) {
    if (samples->time[row] < latest) ++left_out.num_back;
    latest = std::max(latest, samples->time[row]);
  }
  if (left_out.num_back > 0) std::stable_sort(rows.begin(), rows.end(), is_before);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i + 1 < rows.size() && !is_before(rows[i], rows[i + 1])) {
      ++left_out.repeated;
    } else {
      kept.push_back(rows[i]);
    }
  }
  Keep(kept, samples);
  return left_out;
}

double StepOf(const ChannelSamples& samples) {
  return samples.time.size() < 2 ? 0.0 : MedianStep(samples.time);
}

std::vector<std::vector<double>> InterpolatedAt(const ChannelSamples& samples,
                                                const std::vector<double>& time,
                                                double longest_gap) {
  std::vector<std::vector<double>> result(samples.values.size(),
                                          std::vector<double>(time.size(), kNan));
  for (std::size_t row = 0; row < time.size(); ++row) {
    const auto after = std::lower_bound(samples.time.begin(), samples.time.end(), time[row]);
    if (after == samples.time.end()) continue;
    const auto index = static_cast<std::size_t>(after - samples.time.begin());
    if (*after == time[row]) {
      for (std::size_t k = 0; k < result.size(); ++k) result[k][row] = samples.values[k][index];
      continue;
    }
    if (index == 0) continue;
    const double step = samples.time[index] - samples.time[index - 1];
    if (step > longest_gap) continue;
    const double share = (time[row] - samples.time[index - 1]) / step;
    for (std::size_t k = 0; k < result.size(); ++k) {
      const auto& column = samples.values[k];
      result[k][row] = column[index - 1] + share * (column[index] - column[index - 1]);
    }
    if (samples.quaternion) Slerp(samples, index, share, row, &result);
  }
  return result;
}

ChannelSamples Held(const std::vector<ChannelSamples>& channels) {
  if (channels.size() == 1) return channels.front();
  double first = -std::numeric_limits<double>::infinity();
  ChannelSamples held;
  for (const ChannelSamples& channel : channels) {
    held.channel += (held.channel.empty() ? "" : " and ") + channel.channel;
    held.values.resize(held.values.size() + channel.values.size());
    // Of a channel without a sample nothing is known at any time.
    first = std::max(
        first,
        channel.time.empty() ? std::numeric_limits<double>::infinity() : channel.time.front());
  }
  for (const double time : StampsOfAll(channels)) {
    if (time >= first) held.time.push_back(time);
  }
  std::size_t column = 0;
  for (const ChannelSamples& channel : channels) {
    for (const std::vector<double>& values : channel.values) {
      for (const double time : held.time) {
        const auto after = std::upper_bound(channel.time.begin(), channel.time.end(), time);
        held.values[column].push_back(values[after - channel.time.begin() - 1]);
      }
      ++column;
    }
  }
  return held;
}

ChannelSamples Joined(const std::vector<ChannelSamples>& channels, std::size_t* num_alone) {
  *num_alone = 0;
  if (channels.size() == 1) return channels.front();
  const auto base = std::min_element(
      channels.begin(), channels.end(), [](const ChannelSamples& a, const ChannelSamples& b) {
        return a.time.size() < b.time.size();
      });
  ChannelSamples joined;
  joined.time = base->time;
  for (const ChannelSamples& channel : channels) {
    const double gap = std::max(kGapSteps * StepOf(channel), kShortestGap);
    auto columns = &channel == &*base ? channel.values : InterpolatedAt(channel, joined.time, gap);
    for (auto& column : columns) joined.values.push_back(std::move(column));
    joined.channel += (joined.channel.empty() ? "" : " and ") + channel.channel;
  }
  std::vector<std::size_t> kept;
  for (std::size_t row = 0; row < joined.time.size(); ++row) {
    if (std::all_of(joined.values.begin(), joined.values.end(), [&](const auto& column) {
          return std::isfinite(column[row]);
        })) {
      kept.push_back(row);
    }
  }
  *num_alone = joined.time.size() - kept.size();
  Keep(kept, &joined);
  return joined;
}

}  // namespace fathom
