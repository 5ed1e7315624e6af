// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// A number that each sample of a channel holds.
struct Field {
  std::string name;  // "Roll", "pose.position.x", a column's name without its unit
  std::string unit;  // as the file states it; empty: it states none
  int number = 0;    // of a table's column, from 1, the columns of words counted too
};

// One kind of message, topic or table of a recording.
struct Channel {
  std::string name;           // "RCOU", "BARO[1]", "/odom"; empty: the only table of a file
  std::string type;           // "RCOU", "nav_msgs/Odometry"
  std::vector<Field> fields;  // those that are numbers
  std::uint64_t count = 0;
  std::optional<double> first;  // smallest and largest stamp [s]; nothing without stamps
  std::optional<double> last;
  std::optional<Field> clock = {};  // the column of the stamps, where they are a column
  bool clock_counts_rows = false;   // a column 0, 1, 2, ... that no name calls a time
};

// What a recording holds, and how much of it could be read.
struct Contents {
  std::string format;             // "csv", "dataflash"
  std::vector<Channel> channels;  // by name
  std::uint64_t read_bytes = 0;   // up to here the file is sound
  std::uint64_t size_bytes = 0;
  std::vector<std::string> remarks;          // what was passed over, counted, a sentence each
  std::optional<double> utc_of_zero;         // UTC of stamp 0 where that is known [s since 1970]
  std::map<std::string, double> parameters;  // settings of the autopilot, as they were at the end

  bool IsComplete() const { return read_bytes == size_bytes; }

  // Says that ArduPilot's simulator wrote it, if its settings (SIM_...) tell.
  void TellSimulation();
};

// Some fields of a channel.
struct Selection {
  std::string channel;
  std::vector<std::string> fields;
};

// Takes a sample of the selection with this index: its stamp [s], NaN where there is none, and the
// fields in the order of the selection, in the units that Contents states, NaN for an empty one.
// The values last for the call.
using SampleSink =
    std::function<void(std::size_t selection, double time, std::span<const double> values)>;

// A file or folder that a vehicle's own software wrote. Memory does not grow with its size.
class Recording {
 public:
  virtual ~Recording() = default;

  virtual const Contents& contents() const = 0;

  // Hands on every sample of the selected channels, in the order of the file. Gives what is wrong
  // with the file that the contents do not tell, a sentence each: a list may be by an index. Throws
  // InputError for a channel or field that there is none of.
  virtual std::vector<std::string> Read(std::span<const Selection> selections,
                                        const SampleSink& sink) const = 0;
};

}  // namespace fathom
