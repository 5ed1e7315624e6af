// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/mass_check.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kRounded = 1.1;   // up to here both may be the same vehicle, weighed twice
constexpr double kOneWrong = 2.0;  // no payload doubles a vehicle

}  // namespace

std::optional<Finding> CheckMass(double in_log, double in_vehicle) {
  const double ratio = std::max(in_log / in_vehicle, in_vehicle / in_log);
  if (!(ratio > kRounded)) return std::nullopt;
  return Finding{
      ratio > kOneWrong ? Severity::kWarning : Severity::kNote,
      "mass",
      fmt::format("log.yaml says a mass of {:.4g} kg, the vehicle file {:.4g} kg: {:.3g} "
                  "times as much. That of log.yaml is taken.",
                  in_log,
                  in_vehicle,
                  in_vehicle / in_log)};
}

}  // namespace fathom
