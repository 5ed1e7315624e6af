// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/log_offset.h"

#include "fathom/report/format_value.h"

#include <cmath>

#include <fmt/format.h>

namespace fathom {

Table OffsetTable(std::span<const LogOffset> offsets, Dof dof, const std::string& force_unit) {
  const std::string unit = UnitText(force_unit);
  Table table;
  table.columns = {{"log"},
                   {fmt::format("buoyancy [{}]", unit), true},
                   {"95 % interval", true},
                   {fmt::format("training MAE [{}]", UnitText(VelocityUnit(dof))), true, 1},
                   {"training NMAE", true}};
  for (const LogOffset& offset : offsets) {
    table.rows.push_back({{offset.log,
                           FormatValue(offset.value, offset.std),
                           FormatInterval(offset.value, offset.std),
                           fmt::format("{:.5f}", offset.train.mae),
                           fmt::format("{:.4f}", offset.train.nmae)}});
  }
  return table;
}

std::string RemarkOnOffsets(std::span<const LogOffset> offsets, const std::string& force_unit) {
  if (offsets.size() < 2) return "";
  const auto count = static_cast<double>(offsets.size());
  double mean = 0.0, sum_of_squares = 0.0;
  for (const LogOffset& offset : offsets) mean += offset.value / count;
  for (const LogOffset& offset : offsets) sum_of_squares += std::pow(offset.value - mean, 2);
  return fmt::format(
      "Each log has a buoyancy of its own; the model and its figures have their mean. They scatter "
      "by {:.2g} {} (standard deviation): that of another run is known no better.",
      std::sqrt(sum_of_squares / (count - 1.0)),
      force_unit);
}

}  // namespace fathom
