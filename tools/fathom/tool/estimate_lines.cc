// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/estimate_lines.h"

#include "fathom/vehicle/parameters.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace fathom {
namespace {

// The shortest text that is read as this number; a 0 without a sign.
std::string NumberOr(const char* if_not_known, double number) {
  return std::isfinite(number) ? fmt::format("{}", number + 0.0) : if_not_known;
}

}  // namespace

std::string EstimateCsvHeader() {
  std::string line = "t";
  for (const ParameterInfo& info : kParameterInfo) line += fmt::format(",{}", info.name);
  for (const ParameterInfo& info : kParameterInfo) line += fmt::format(",{}_std", info.name);
  return line + ",usable\n";
}

std::string EstimateCsvLine(const FollowedEstimate& estimate) {
  const ParameterVector values = ToVector(estimate.model);
  std::string line = fmt::format("{}", estimate.t);
  for (const double value : values) line += "," + NumberOr("", value);
  for (const double std : estimate.std) line += "," + NumberOr("", std);
  return line + (estimate.usable ? ",1\n" : ",0\n");
}

std::string EstimateJsonLine(const FollowedEstimate& estimate, Dof dof) {
  const ParameterVector values = ToVector(estimate.model);
  std::string line =
      fmt::format(R"({{"t": {}, "usable": {}, "parameters": {{)", estimate.t, estimate.usable);
  for (int k = 0; k < kNumParameters; ++k) {
    fmt::format_to(std::back_inserter(line),
                   R"({}"{}": {{"value": {}, "std": {}, "unit": "{}"}})",
                   k == 0 ? "" : ", ",
                   kParameterInfo[k].name,
                   NumberOr("null", values[k]),
                   NumberOr("null", estimate.std[k]),
                   ParameterUnit(k, dof, std::string(ForceUnit(dof))));
  }
  return line + "}}\n";
}

}  // namespace fathom
