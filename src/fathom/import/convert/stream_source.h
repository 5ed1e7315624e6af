// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/map/import_map.h"
#include "fathom/import/recording/recording.h"
#include "fathom/import/units/unit.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A column of a stream as a recording holds it. A reversed motor turns the other way round: its
// command changes sign, and its pulse p becomes 3000 us - p; a pulse of 0 stays off.
struct ColumnSource {
  std::string column;   // its name in the log
  Selection selection;  // of one field, or of those that are added up
  Unit unit;            // of the number, after `scale` and `offset`
  double scale = 1.0;
  double offset = 0.0;
  bool is_reversed = false;  // of a thruster

  // Of stamps whose unit nobody states: it is `unit` only once their size is known.
  bool is_unit_open = false;

  double InSi(double number) const;
};

// The dimension that a column of a log holds: of "u" a speed, of "tau_yaw" a moment, of "voltage" a
// voltage. Nothing of thruster_1, ..., whose unit tells it.
std::optional<Dimension> DimensionOf(std::string_view column);

// Where a column comes from, with its unit: that of the map, else the one that the recording
// states, else the SI unit, which `remarks` then tells. `plain`: the number stays as it is. Throws
// InputError, naming `file` and the column, for a channel, field or unit that there is none of.
ColumnSource SourceOf(const std::filesystem::path& file,
                      const Contents& contents,
                      const StreamMap& stream,
                      const std::string& column,
                      const ColumnMap& map,
                      bool is_plain,
                      std::vector<std::string>* remarks);

}  // namespace fathom
