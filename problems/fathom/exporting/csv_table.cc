// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/csv_table.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/format_features.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

// In quotes where a reader would take it for several cells.
std::string Cell(const std::string& text) {
  const std::string line = CommentText(text);
  if (line.find_first_of(",\"") == std::string::npos) return line;
  std::string quoted = "\"";
  for (const char c : line) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string NumberCell(double value) { return std::isfinite(value) ? LiteralOf(value) : ""; }

std::string Row(const std::string& name,
                double value,
                double std,
                const Interval95& interval,
                const std::string& unit,
                const std::string& frame,
                const std::string& log,
                bool is_identified) {
  return fmt::format("{},{},{},{},{},{},{},{},{}\n",
                     Cell(name),
                     NumberCell(value),
                     NumberCell(std),
                     NumberCell(interval.low),
                     NumberCell(interval.high),
                     Cell(unit),
                     frame,
                     Cell(log),
                     is_identified ? "identified" : "held");
}

std::string FrameOf(const FreeEntry& entry) {
  switch (entry.kind) {
    case FreeEntry::Kind::kNetBuoyancy:
      return "world: up";
    case FreeEntry::Kind::kThrustGain:
    case FreeEntry::Kind::kThrusterEffect:
      return "thruster";
    case FreeEntry::Kind::kFinForce:
    case FreeEntry::Kind::kFinRace:
    case FreeEntry::Kind::kFinNeutral:
    case FreeEntry::Kind::kFinStuck:
    case FreeEntry::Kind::kFinLag:
    case FreeEntry::Kind::kFinRateLimit:
    case FreeEntry::Kind::kFinStall:
      return "fin";
    default:
      return "body: FRD about its origin";
  }
}

}  // namespace

ExportedFile CsvTable(const ExportModel& model, const ExportTarget& target) {
  ExportedFile file;
  file.remarks = RemarksOn(ExportFormat::kCsv, model, target);
  for (const std::string& line : HeadLines(model, target, file.remarks)) {
    file.text += fmt::format("# {}\n", line);
  }
  file.text += fmt::format(
      "# M dnu/dt + C(nu) nu + D(nu) nu + g(eta) + o = tau; C(nu): {}. FRD: x forward, y "
      "starboard, z down.\n"
      "name,value,std,low_95,high_95,unit,frame,log,source\n",
      model.model.coriolis ? "of M" : "none");
  for (const ExportNumber& number : model.numbers) {
    file.text += Row(NameOf(number.entry),
                     number.value,
                     number.std,
                     IntervalOf(number),
                     number.unit,
                     FrameOf(number.entry),
                     number.log,
                     number.is_identified);
  }
  for (const ExportEffect& effect : model.effects) {
    for (const ExportEffectValue& value : effect.values) {
      file.text += Row(fmt::format("{}.{}.{}", effect.label, Name(effect.dof), value.name),
                       value.value,
                       value.std,
                       IntervalOf(value),
                       value.unit,
                       fmt::format("effect on {}", Name(effect.dof)),
                       effect.log,
                       true);
    }
  }
  return file;
}

}  // namespace fathom
