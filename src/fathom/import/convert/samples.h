// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fathom {

// Columns over the stamps of one channel, in SI.
struct ChannelSamples {
  std::string channel;
  std::vector<double> time;                 // [s]
  std::vector<std::vector<double>> values;  // values[column][row]
};

// What was left out of samples, counted.
struct LeftOutRows {
  std::size_t incomplete = 0;  // a cell is empty where another of its row is not
  std::size_t repeated = 0;    // another row of the same stamp follows it
  bool was_sorted = false;     // stamps went back
};

// Removes rows that hold nothing, and those of `LeftOutRows`, and sorts what goes back. Of rows of
// one stamp the last stays.
LeftOutRows Clean(ChannelSamples* samples);

// The median step between the stamps [s]; 0 of less than two.
double StepOf(const ChannelSamples& samples);

// The columns of `samples` at the stamps `time`: between two samples on a straight line, NaN where
// they are more than `longest_gap` [s] apart, and outside of them.
std::vector<std::vector<double>> InterpolatedAt(const ChannelSamples& samples,
                                                const std::vector<double>& time,
                                                double longest_gap);

// All columns of several channels at the stamps of the one with the fewest samples. Rows without a
// value of another within three of its steps, or half a second, are left out; `num_alone` counts
// them.
ChannelSamples Joined(const std::vector<ChannelSamples>& channels, std::size_t* num_alone);

}  // namespace fathom
