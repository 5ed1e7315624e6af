// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/export_format.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

struct FormatInfo {
  std::string_view name, description;
};

// In the order of ExportFormat.
constexpr std::array<FormatInfo, kExportFormats.size()> kFormatInfo = {
    {{"c", "a header in C99"},
     {"csv", "a table"},
     {"gazebo", "a model of SDF 1.10"},
     {"mss", "a function of MATLAB and Octave"},
     {"stonefish", "a robot of Stonefish"},
     {"uuv", "a model for uuv_simulator and Plankton"},
     {"vrx", "a model for VRX"}}};

const FormatInfo& InfoOf(ExportFormat format) {
  return kFormatInfo[static_cast<std::size_t>(format)];
}

}  // namespace

std::string_view Name(ExportFormat format) { return InfoOf(format).name; }

std::string_view DescriptionOf(ExportFormat format) { return InfoOf(format).description; }

std::string ExportFormatNames() {
  std::string names;
  for (const FormatInfo& info : kFormatInfo) {
    const bool is_last = &info == &kFormatInfo.back();
    names += fmt::format("{}{}", names.empty() ? "" : is_last ? " or " : ", ", info.name);
  }
  return names;
}

ExportFormat ParseExportFormat(std::string_view name) {
  for (const ExportFormat format : kExportFormats) {
    if (Name(format) == name) return format;
  }
  throw InputError(fmt::format("is {}, expected {}.", Quoted(name), ExportFormatNames()));
}

}  // namespace fathom
