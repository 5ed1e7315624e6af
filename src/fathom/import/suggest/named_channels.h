// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/channel_facts.h"

#include <string>
#include <vector>

namespace fathom {

// Fields of one rate, by names that tell what they are.
struct NamedChannel {
  Channel channel;
  std::vector<FieldPlace> places;  // of its fields
  std::string time_channel;        // an array with a stamp for each sample; empty: there is none
};

// The channels of a recording. Of a .mat, .npy or .npz, all arrays without stamps that have as many
// samples are one, and their fields have the names of the arrays: "u" of an array u; of an array
// eta, whose columns have numbers, x, y, z, roll, pitch, yaw. The only column of a table, "field"
// or "data", is called as the table.
std::vector<NamedChannel> NamedChannels(const Contents& contents);

}  // namespace fathom
