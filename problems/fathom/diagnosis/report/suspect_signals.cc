// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/suspect_signals.h"

#include "fathom/report/scatter_chart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kEpoch = 1e6;           // stamps beyond this count from some epoch [s]
constexpr double kMoreThanChance = 0.3;  // of the variance

SuspectSignal TimeOf(const MissingForce& missing) {
  SuspectSignal time = {"time", "s", missing.time, true};
  if (missing.time.empty() || std::abs(missing.time.front()) <= kEpoch) return time;
  const double offset = std::floor(missing.time.front());
  for (double& stamp : time.values) stamp -= offset;
  time.name = fmt::format("time + {:.0f} s", offset);
  return time;
}

}  // namespace

std::vector<SuspectSignal> SuspectSignalsOf(const Diagnosis& diagnosis) {
  const MissingForce& missing = diagnosis.missing_force;
  const std::string& force_unit = diagnosis.force_unit;
  std::vector<SuspectSignal> signals = {
      {"command", force_unit, missing.command},
      {"command rate", force_unit + "/s", missing.command_rate},
      {fmt::format("{} velocity", Name(diagnosis.dof)),
       std::string(VelocityUnit(diagnosis.dof)),
       missing.velocity},
      {"displacement", std::string(DisplacementUnit(diagnosis.dof)), missing.displacement},
      TimeOf(missing)};
  for (std::size_t k = 0; k < missing.partner_velocities.size(); ++k) {
    const std::string partner =
        k < missing.partner_names.size() ? missing.partner_names[k] : "another DOF";
    const auto dof = DofFromName(partner);
    signals.push_back({partner + " velocity",
                       dof ? std::string(VelocityUnit(*dof)) : "",
                       missing.partner_velocities[k]});
  }
  std::erase_if(signals, [&](const SuspectSignal& signal) {
    if (signal.values.empty() || signal.values.size() != missing.mean.size()) return true;
    const auto [least, most] = std::minmax_element(signal.values.begin(), signal.values.end());
    return !(*most > *least);
  });
  return signals;
}

double ShareExplainedBy(const SuspectSignal& signal, const std::vector<double>& force) {
  constexpr int kNumBins = 24;
  return ShareBetweenBins(signal.values, force, kNumBins);
}

std::optional<FollowedSignal> FollowedByTheRest(const Diagnosis& diagnosis) {
  std::vector<double> rest = diagnosis.missing_force.mean;
  const std::vector<double>& explained = diagnosis.missing_force.explained;
  for (std::size_t i = 0; i < std::min(rest.size(), explained.size()); ++i) rest[i] -= explained[i];
  std::optional<FollowedSignal> best;
  for (const SuspectSignal& signal : SuspectSignalsOf(diagnosis)) {
    if (signal.is_time) continue;
    const double share = ShareExplainedBy(signal, rest);
    if (share > (best ? best->share : kMoreThanChance)) best = {signal.name, share};
  }
  return best;
}

}  // namespace fathom
