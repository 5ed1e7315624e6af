// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/fin_pulses.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kOffPulse = 800.0;  // below it an output is off [us]

double LargestAngle(const std::filesystem::path& file,
                    const std::string& column,
                    const ColumnMap& map,
                    const std::optional<Vehicle>& vehicle) {
  if (map.largest_angle) return *map.largest_angle;
  const std::string name = column.substr(std::string_view("fin_").size());
  if (vehicle) {
    const auto fin = std::ranges::find(vehicle->fins, name, &Fin::name);
    if (fin != vehicle->fins.end() && fin->largest_angle) return *fin->largest_angle;
  }
  throw InputError(fmt::format(
      "{}: command: {} is of pulses, and nothing tells the angle at full deflection, expected "
      "`largest_angle` [rad] of the fin '{}' in the vehicle file or of this column in the map.",
      file.string(),
      column,
      name));
}

}  // namespace

void AnglesOfPulses(const std::filesystem::path& file,
                    const StreamMap& command,
                    const std::optional<Vehicle>& vehicle,
                    Stream* fins,
                    std::vector<std::string>* remarks) {
  for (std::size_t k = 0; k < fins->columns.size(); ++k) {
    const std::string& column = fins->columns[k];
    const ColumnMap* map = command.Find(column);
    if (map == nullptr || !map->pulses) continue;
    const auto& [least, middle, most] = *map->pulses;
    const double largest =
        (map->is_reversed ? -1.0 : 1.0) * LargestAngle(file, column, *map, vehicle);
    std::size_t num_off = 0, num_beyond = 0;
    for (double& value : fins->values[k]) {
      if (value < kOffPulse) {
        ++num_off;
        value = 0.0;
        continue;
      }
      const double share = (value - middle) / (value > middle ? most - middle : middle - least);
      if (share < -1.0 || share > 1.0) ++num_beyond;
      value = largest * std::clamp(share, -1.0, 1.0);
    }
    const auto tell = [&](std::size_t num, const std::string& what) {
      if (num == 0) return;
      remarks->push_back(fmt::format(
          "command: {}: at {} of {} {}.", column, Plural(num, "row"), fins->time.size(), what));
    };
    tell(num_off, "the output is off, and the fin is taken as straight");
    tell(num_beyond,
         fmt::format(
             "the pulse is beyond {:g} to {:g} us, and the angle there is taken", least, most));
  }
}

}  // namespace fathom
