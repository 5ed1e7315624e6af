// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/export_format.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/exporting/c_header.h"
#include "fathom/exporting/export_checks.h"
#include "fathom/exporting/gazebo.h"
#include "fathom/exporting/mss.h"

#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::array<std::string_view, 3> kFormatNames = {"c", "gazebo", "mss"};

ExportedFile FileIn(const ExportModel& model, const ExportTarget& target, ExportFormat format) {
  switch (format) {
    case ExportFormat::kC:
      return CHeader(model, target);
    case ExportFormat::kGazebo:
      return GazeboModel(model, target);
    case ExportFormat::kMss:
      return MssFunction(model, target);
  }
  return {};
}

}  // namespace

std::string_view Name(ExportFormat format) {
  return kFormatNames[static_cast<std::size_t>(format)];
}

std::string_view DescriptionOf(ExportFormat format) {
  switch (format) {
    case ExportFormat::kC:
      return "a header in C99";
    case ExportFormat::kGazebo:
      return "a model of SDF 1.10";
    case ExportFormat::kMss:
      return "a function of MATLAB and Octave";
  }
  return "";
}

ExportFormat ParseExportFormat(std::string_view name) {
  for (std::size_t i = 0; i < kFormatNames.size(); ++i) {
    if (kFormatNames[i] == name) return static_cast<ExportFormat>(i);
  }
  throw InputError(fmt::format("is {}, expected c, gazebo or mss.", Quoted(name)));
}

ExportedFile Export(const ExportModel& model, const ExportTarget& target, ExportFormat format) {
  std::vector<std::string> problems = CheckExport(model.model);
  if (!problems.empty()) return {"", {}, std::move(problems)};
  return FileIn(model, target, format);
}

}  // namespace fathom
