// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// Columns over the stamps of one channel, in SI.
struct ChannelSamples {
  std::string channel;
  std::vector<double> time;                 // [s]
  std::vector<std::vector<double>> values;  // values[column][row]

  // Where the columns hold a quaternion: the four of them.
  std::optional<std::array<std::size_t, 4>> quaternion = {};
};

// What was left out of samples, counted.
struct LeftOutRows {
  std::size_t empty = 0;       // no cell is a number, as of a channel with NaN
  std::size_t incomplete = 0;  // a cell is empty where another of its row is not
  std::size_t repeated = 0;    // another row of the same stamp follows it
  std::size_t num_back = 0;    // not left out, but sorted: a stamp before the largest so far
};

// Removes the rows of `LeftOutRows`, and sorts what goes back. Of rows of
// one stamp the last stays.
LeftOutRows Clean(ChannelSamples* samples);

// The median step between the stamps [s]; 0 of less than two.
double StepOf(const ChannelSamples& samples);

// The columns of `samples` at the stamps `time`: between two samples on a straight line, a
// quaternion on the great circle from one to the other; NaN where they are more than `longest_gap`
// [s] apart, and outside of them.
std::vector<std::vector<double>> InterpolatedAt(const ChannelSamples& samples,
                                                const std::vector<double>& time,
                                                double longest_gap);

// What several channels command, each of which holds its value until its next sample: a row at the
// stamps of all, from the first on at which each channel has a value. Stamps of one cycle, less
// than a fiftieth of the shortest median step apart, are one row, at the last of them.
ChannelSamples Held(const std::vector<ChannelSamples>& channels);

// All columns of several channels at the stamps of the one with the fewest samples. Rows without a
// value of another within three of its steps, or half a second, are left out; `num_alone` counts
// them.
ChannelSamples Joined(const std::vector<ChannelSamples>& channels, std::size_t* num_alone);

}  // namespace fathom
