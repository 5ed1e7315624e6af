// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What a map for an autopilot's log has to know of its channels.

// Below this pulse width an output is off, or sends no pulses [us].
constexpr double kShortestPulse = 800;

// The channel of a type, its first instance of two samples or more; empty if there is none.
std::string FirstChannelOf(const Contents& contents, std::string_view type);

bool HasField(const Channel& channel, std::string_view field);
bool HasField(const Contents& contents, const std::string& channel, std::string_view field);

// Where a field is.
struct FieldPlace {
  std::string channel;
  std::string field;
};

// Which of these fields ever reach a value. One without a name does not.
std::vector<bool> ThatReach(const Recording& recording,
                            std::span<const FieldPlace> places,
                            double value);

// How many of these fields, from the first on, ever reach a value. Those that the channel does not
// have end the list.
int NumThatReach(const Recording& recording,
                 const std::string& channel,
                 const std::vector<std::string>& fields,
                 double value);

// The largest number of a field, minus infinity where there is none.
double LargestOf(const Recording& recording, const std::string& channel, const std::string& field);

// "C#" of 3: "C3".
std::string WithNumber(std::string field, int number);

}  // namespace fathom
