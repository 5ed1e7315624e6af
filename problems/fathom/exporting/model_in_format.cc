// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/model_in_format.h"

#include "fathom/exporting/c_header.h"
#include "fathom/exporting/csv_table.h"
#include "fathom/exporting/export_checks.h"
#include "fathom/exporting/gazebo.h"
#include "fathom/exporting/mss.h"
#include "fathom/exporting/stonefish.h"
#include "fathom/exporting/uuv.h"
#include "fathom/exporting/vrx.h"

#include <string>
#include <utility>
#include <vector>

namespace fathom {
namespace {

ExportedFile FileIn(const ExportModel& model, const ExportTarget& target, ExportFormat format) {
  switch (format) {
    case ExportFormat::kC:
      return CHeader(model, target);
    case ExportFormat::kCsv:
      return CsvTable(model, target);
    case ExportFormat::kGazebo:
      return GazeboModel(model, target);
    case ExportFormat::kMss:
      return MssFunction(model, target);
    case ExportFormat::kStonefish:
      return StonefishRobot(model, target);
    case ExportFormat::kUuv:
      return UuvModel(model, target);
    case ExportFormat::kVrx:
      return VrxModel(model, target);
  }
  return {};
}

}  // namespace

ExportedFile Export(const ExportModel& model, const ExportTarget& target, ExportFormat format) {
  std::vector<std::string> problems = CheckExport(model.model);
  if (!problems.empty()) return {"", {}, std::move(problems)};
  return FileIn(model, target, format);
}

}  // namespace fathom
