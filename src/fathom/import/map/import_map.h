// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/time_interval.h"
#include "fathom/import/map/camera_map.h"
#include "fathom/import/table/table_layout.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fathom {

// The axes that numbers are along.
enum class Frame {
  kFrd,  // body: x forward, y right, z down
  kFlu,  // body: x forward, y left, z up
  kNed,  // world: x north, y east, z down; body kFrd
  kEnu,  // world: x east, y north, z up; body kFlu
  kNwu,  // world: x north, or anywhere, y left of it, z up; body kFlu
};

// Where a column of a log comes from.
struct ColumnMap {
  std::string channel;             // empty: the stream's
  std::string field;               // its name, or its number from 1 on
  std::vector<std::string> added;  // further fields of the channel, in the same unit: their sum
  std::string unit;                // empty: the stream's, or what the recording states, or SI
  double scale = 1.0;              // of the number as it stands, with its sign
  double offset = 0.0;             // added after the scale, in the same unit
  bool is_reversed = false;        // of a thruster: the motor turns the other way round; of a fin
                                   // by pulses: the larger pulse is the smaller angle

  // Of a fin whose servo's pulses are logged: the least, that at rest and the largest [us], and the
  // angle at either end [rad], where the vehicle file does not tell it.
  std::optional<std::array<double, 3>> pulses = {};
  std::optional<double> largest_angle = {};
};

// Samples of a channel count where a field has this value.
struct Condition {
  std::string field;
  double value = 0.0;
};

// Where a stream of a log comes from.
struct StreamMap {
  std::string channel;  // empty: the only one
  std::optional<Frame> frame;
  std::string unit;            // of all columns that name none; may be empty
  std::optional<double> rate;  // of channels without stamps [Hz]
  // The field that holds the stamps, where they are not the channel's own; with a channel: one of
  // that for each sample of the stream's.
  std::optional<ColumnMap> time;
  std::string nanoseconds;  // a field that is added to `time`, which then holds whole seconds
  double delay = 0.0;       // added to the stamps [s]
  std::vector<Condition> where;
  std::vector<std::pair<std::string, ColumnMap>> columns;  // by the column's name in the log

  // Null if there is none.
  const ColumnMap* Find(std::string_view column) const;
};

// What turns a recording into a log; docs/import.md.
struct ImportMap {
  std::string name;       // of the log; empty: that of the recording
  std::vector<Dof> dofs;  // empty: those that the command moves
  std::string vehicle;    // a vehicle file, from the map's folder on
  std::optional<double> mass;
  std::string dive;
  std::string notes;
  std::vector<TimeInterval> held_out;  // in the time of the log
  std::string command_unit;  // where the command is neither N and N m nor can be turned into them
  TableOptions table;
  std::optional<StreamMap> command;     // tau_* or thruster_1 ..., fin_*, shaft_*
  std::optional<ColumnMap> voltage;     // of the supply, beside `command`
  std::optional<double> fixed_voltage;  // the same where it is not measured [V]
  std::optional<StreamMap> velocity;    // u v w p q r
  std::optional<StreamMap> pose;        // x y z, and qx qy qz qw or roll pitch yaw
  std::optional<CameraMap> camera;
};

// Throws InputError, naming file, line and key, for whatever breaks the format.
ImportMap ReadImportMap(const std::filesystem::path& path);

// The same from memory; `name` stands for the file in messages.
ImportMap ParseImportMap(const std::string& name, const std::string& text);

// The files that a map names: the vehicle's, those of a camera. Throws as ReadImportMap() does.
std::vector<std::filesystem::path> FilesNamedBy(const std::filesystem::path& map_file);

}  // namespace fathom
