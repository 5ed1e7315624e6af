// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/convert/samples.h"
#include "fathom/import/convert/stream_source.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/recording/recording.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// The columns of one stream that one channel holds.
struct ChannelPart {
  Selection selection;  // the columns' fields, then those of the conditions
  std::vector<ColumnSource> columns;
  std::size_t num_fields = 0;              // of all columns together
  std::vector<double> conditions;          // the values that the latter must have
  std::optional<ColumnSource> time;        // the field of the stamps, behind all of them
  bool has_nanoseconds = false;            // a field of these follows the stamps
  std::optional<ColumnSource> other_time;  // instead: stamps of another channel, one a sample
  std::vector<double> other_stamps;        // [s]
  bool is_unit_guessed = false;            // of the stamps
  std::optional<double> rate;
  double delay = 0.0;
  ChannelSamples samples;
  std::uint64_t num_seen = 0;     // that the conditions let through
  std::uint64_t num_samples = 0;  // of the channel

  // A sample of the channel, in the order of the selection.
  void Take(double time, std::span<const double> values);

  // The stamp of a sample of `other_time`.
  void TakeStamp(std::span<const double> values);
};

// What the columns of a map ask of each channel, with its conditions and stamps; as SourceOf().
// `is_plain`: numbers of a command stay as they are.
std::vector<ChannelPart> ChannelPartsOf(const std::filesystem::path& file,
                                        const Contents& contents,
                                        const StreamMap& stream,
                                        bool is_plain,
                                        std::vector<std::string>* remarks);

// Gives the samples of a part the stamps that another channel holds.
void TakeOtherStamps(const std::filesystem::path& file, ChannelPart* part);

// Says of which unit stamps were taken that state none.
void TellStampUnit(const ChannelPart& part, std::vector<std::string>* remarks);

}  // namespace fathom
