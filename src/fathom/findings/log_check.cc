// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/log_check.h"

#include "fathom/findings/followed_command.h"
#include "fathom/findings/mass_check.h"
#include "fathom/findings/motion_check.h"
#include "fathom/findings/other_axes.h"
#include "fathom/findings/pose_twist_check.h"
#include "fathom/findings/signal_check.h"
#include "fathom/findings/stamp_check.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/vehicle/files/thruster_shares.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

void Add(std::vector<Finding> more, std::vector<Finding>* findings) {
  std::ranges::move(more, std::back_inserter(*findings));
}

// The same, beginning with the name of the log's folder where it is one of several.
std::vector<Finding> OfLog(const Log& log, std::size_t num_logs, std::vector<Finding> findings) {
  if (num_logs == 1) return findings;
  for (Finding& finding : findings) {
    finding.sentence = fmt::format("{}: {}", log.path.filename().string(), finding.sentence);
  }
  return findings;
}

// Length, width and height of the vehicle [m], where the log names a vehicle file that knows them.
std::optional<std::array<double, 3>> SizeOf(const Log& log) {
  const std::optional<Vehicle> vehicle = VehicleOf(log);
  if (!vehicle || !vehicle->size) return std::nullopt;
  return std::array{vehicle->size->x(), vehicle->size->y(), vehicle->size->z()};
}

// The masses of log.yaml and of the vehicle file that it names.
std::vector<Finding> CheckMassOf(const Log& log) {
  const std::optional<Vehicle> vehicle = VehicleOf(log);
  if (!log.mass || !vehicle || !vehicle->mass) return {};
  std::vector<Finding> findings;
  if (auto finding = CheckMass(*log.mass, *vehicle->mass)) findings.push_back(*std::move(finding));
  return findings;
}

// `signals` are those of all logs.
std::vector<Finding> CheckOtherAxesOf(const Log& log, const Signals& signals) {
  if (!log.velocity) return {};
  const Signals own = SignalsOf(log, signals.dof, {.source = signals.source});
  std::vector<Finding> findings;
  if (auto finding = CheckOtherAxes(log, signals.dof, own.train)) {
    findings.push_back(*std::move(finding));
  }
  return findings;
}

LoggedQuantities QuantitiesOf(std::span<const Log> logs) {
  LoggedQuantities logged;
  for (const Log& log : logs) {
    const bool is_of_speeds = log.thrusters && log.thruster_unit.empty();
    (is_of_speeds ? logged.thruster_speed : logged.force) = true;
    logged.velocity |= log.velocity.has_value();
  }
  return logged;
}

// Of the stamps, which all DOFs share; the others of CheckSignals() are of force and speed.
bool IsOfStamps(const Finding& finding) {
  return finding.code == "sampling_rate" || finding.code == "jitter" || finding.code == "gap";
}

// What CheckSignals() says of one DOF of several begins with its name.
std::vector<Finding> SignalFindings(const std::vector<Segment>& segments,
                                    Dof dof,
                                    const std::string& unit,
                                    bool is_of_several) {
  std::vector<Finding> findings = CheckSignals(segments, dof, unit);
  if (!is_of_several) return findings;
  for (Finding& finding : findings) {
    if (IsOfStamps(finding)) continue;
    finding.sentence = fmt::format("{}: {}", Name(dof), finding.sentence);
  }
  return findings;
}

bool IsDriven(const Log& log, Dof dof) {
  const auto* force = log.command ? log.command->Find(ForceColumn(dof)) : nullptr;
  return force != nullptr &&
         std::ranges::any_of(*force, [&](double f) { return f != (*force)[0]; });
}

bool IsDriven(std::span<const Log> logs, Dof dof) {
  return std::ranges::any_of(logs, [&](const Log& log) { return IsDriven(log, dof); });
}

// What moves the others where one DOF of several alone is driven?
std::optional<Finding> CheckUndriven(std::span<const Log> logs, const std::vector<Dof>& dofs) {
  const bool has_surfaces =
      std::ranges::any_of(logs, [](const Log& log) { return log.fins || log.shafts; });
  std::vector<std::string_view> undriven;
  for (const Dof dof : dofs) {
    if (!IsDriven(logs, dof)) undriven.push_back(Name(dof));
  }
  if (has_surfaces || undriven.size() < 2 || undriven.size() + 1 < dofs.size()) return std::nullopt;
  return Finding{Severity::kWarning,
                 "undriven",
                 fmt::format("No command acts on {}: what moves the vehicle there is not in the "
                             "log. Name a rudder's angle fin_NAME [rad] in command.csv "
                             "(docs/fins.md), or leave these out of --dofs.",
                             fmt::join(undriven, ", "))};
}

std::vector<Finding> CheckOneDof(std::span<const Log> logs, Dof dof, bool is_of_several) {
  std::vector<Finding> findings;
  std::vector<Segment> segments;
  for (const Log& log : logs) {
    const Source source = BestSourceOf(log, dof);
    Add(OfLog(log, logs.size(), CheckStamps(log)), &findings);
    Add(OfLog(log, logs.size(), CheckMassOf(log)), &findings);
    Add(OfLog(log, logs.size(), CheckMotion(log, dof, source)), &findings);
    Add(OfLog(log, logs.size(), CheckOtherMotion(log, dof)), &findings);
    Add(OfLog(log, logs.size(), CheckFollowedCommand(log, dof)), &findings);
    Signals signals = SignalsOf(log, dof, {.source = source});
    std::ranges::move(signals.train, std::back_inserter(segments));
  }
  Add(SignalFindings(segments, dof, CommandUnitOf(logs.front(), dof), is_of_several), &findings);
  return WarningsFirst(std::move(findings));
}

}  // namespace

std::vector<Finding> CheckLogs(std::span<const Log> logs, const Signals& signals) {
  std::vector<Finding> findings;
  for (const Log& log : logs) {
    Add(OfLog(log, logs.size(), CheckStamps(log)), &findings);
    Add(OfLog(log, logs.size(), CheckMassOf(log)), &findings);
    Add(OfLog(log, logs.size(), CheckMotion(log, signals.dof, signals.source)), &findings);
    Add(OfLog(log, logs.size(), CheckFollowedCommand(log, signals.dof)), &findings);
    Add(OfLog(log, logs.size(), CheckOtherAxesOf(log, signals)), &findings);
  }
  Add(CheckSignals(signals), &findings);
  return WarningsFirst(std::move(findings));
}

std::vector<Finding> CheckLogs(std::span<const Log> logs, Dof dof) {
  return CheckOneDof(logs, dof, /*is_of_several=*/false);
}

std::vector<Finding> CheckLogs(std::span<const Log> logs, const std::vector<Dof>& dofs) {
  std::vector<Finding> findings;
  for (const Log& log : logs) Add(OfLog(log, logs.size(), CheckPoseAgainstTwist(log)), &findings);
  if (auto finding = CheckUndriven(logs, dofs)) findings.push_back(*std::move(finding));
  for (const Dof dof : dofs) {
    const bool can_be_checked = std::ranges::all_of(logs, [&](const Log& log) {
      return log.command && log.command->Find(ForceColumn(dof)) != nullptr &&
             !SourcesOf(log, dof).empty();
    });
    // Couplings move a DOF that nothing drives.
    if (!can_be_checked || !IsDriven(logs, dof)) continue;
    for (Finding& finding : CheckOneDof(logs, dof, dofs.size() > 1)) {
      const bool is_known = std::ranges::any_of(findings, [&](const Finding& known) {
        return known.code == finding.code && known.sentence == finding.sentence;
      });
      if (!is_known) findings.push_back(std::move(finding));
    }
  }
  return WarningsFirst(std::move(findings));
}

std::string WhyNoModel(const std::vector<Finding>& findings) {
  const auto found = std::ranges::find_if(findings, [](const Finding& finding) {
    return finding.code == "constant_command" || finding.code == "constant_velocity";
  });
  return found == findings.end() ? "" : found->sentence;
}

std::optional<Body> BodyOf(std::span<const Log> logs) {
  std::optional<Body> body;
  for (const Log& log : logs) {
    if (!log.mass) continue;
    const Body own = {*log.mass, SizeOf(log), {}};
    if (body && (body->mass != own.mass || body->size != own.size)) return std::nullopt;
    body = own;
  }
  if (body) body->logged = QuantitiesOf(logs);
  return body;
}

}  // namespace fathom
