// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_plan_text.h"

#include "fathom/planning/ordinary_sine.h"
#include "fathom/planning/plan_text.h"
#include "fathom/planning/planned_motion.h"
#include "fathom/planning/thruster_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// How much narrower the run makes an interval than a sine on each axis; couplings near 0 have no
// share of themselves to be known to.
double GainOf(const PlannedParameter& entry) { return entry.sine / entry.after; }

// How far from 0 the bands reach.
double ReachOf(const PlannedBand& band) {
  double reach = 0.0;
  for (const double value : band.low) reach = std::max(reach, -value);
  for (const double value : band.high) reach = std::max(reach, value);
  return reach;
}

// How fast, how far and how askew the vehicle will be at most.
std::vector<std::string> ReachesOf(const std::vector<Dof>& dofs, const CoupledPlan& plan) {
  constexpr std::array<std::string_view, 3> kWays = {"ahead or back", "aside", "up or down"};
  std::vector<std::string> reaches;
  for (const Dof dof : dofs) {
    reaches.push_back(fmt::format("{} {:.2g} {}",
                                  Name(dof),
                                  ReachOf(plan.speed[static_cast<std::size_t>(Index(dof))]),
                                  VelocityUnit(dof)));
  }
  for (const Dof dof : dofs) {
    if (IsAngular(dof)) continue;
    const auto at = static_cast<std::size_t>(Index(dof));
    reaches.push_back(fmt::format("{:.1f} m {}", ReachOf(plan.position[at]), kWays[at]));
  }
  const bool tilts = std::any_of(
      dofs.begin(), dofs.end(), [](Dof dof) { return dof == Dof::kRoll || dof == Dof::kPitch; });
  if (tilts) reaches.push_back(fmt::format("a tilt of {:.2f} rad", plan.tilt));
  if (!plan.heading.value.empty()) {
    reaches.push_back(fmt::format("a heading {:.2f} rad off the start's", ReachOf(plan.heading)));
  }
  return reaches;
}

// The modelled DOFs whose noise is known by this: "surge, yaw".
std::string NamesOfNoiseBy(NoiseSource source,
                           const CoupledPlanRequest& request,
                           const CoupledPlan& plan) {
  std::vector<std::string_view> names;
  for (const Dof dof : request.model.model.dofs) {
    if (plan.noise_source[static_cast<std::size_t>(Index(dof))] == source) {
      names.push_back(Name(dof));
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

// What noise the intervals hold for, and by what it is known.
std::string NoiseComment(const CoupledPlanRequest& request, const CoupledPlan& plan) {
  std::vector<std::string> noise;
  for (const Dof dof : request.model.model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    noise.push_back(fmt::format("{} {:.2g} {}", Name(dof), plan.noise[at], VelocityUnit(dof)));
  }
  std::string text =
      fmt::format("The intervals hold for noise of {} on {:.3g} velocities a second.",
                  fmt::join(noise, ", "),
                  plan.rate);
  if (const auto names = NamesOfNoiseBy(NoiseSource::kLog, request, plan); !names.empty()) {
    text += fmt::format(" Size and colour of that of {} are the log's.", names);
  }
  if (const auto names = NamesOfNoiseBy(NoiseSource::kLimits, request, plan); !names.empty()) {
    text += fmt::format(" Of {} it is white, as large as the limits file says.", names);
  }
  if (const auto names = NamesOfNoiseBy(NoiseSource::kLogTakenAsWhite, request, plan);
      !names.empty()) {
    text += fmt::format(
        " Of {} it is taken as white, as large as the log shows: {} does not hold its colour. "
        "Coloured noise widens the intervals.",
        names,
        request.name);
  }
  return text;
}

// How well each pair is told apart.
std::string SeparationSentences(const std::vector<PlannedSeparation>& separations) {
  std::string text;
  for (const PlannedSeparation& pair : separations) {
    text +=
        fmt::format(" {} against {}: {} at {:.1f} sigmas ({:.1f} with sines of the same length).",
                    pair.truth,
                    pair.assumed,
                    pair.IsDecided() ? "decided" : "open",
                    pair.sigmas,
                    pair.sine);
  }
  return text;
}

}  // namespace

std::string NamesOfAxes(const CoupledPlan& plan) {
  std::vector<std::string_view> names;
  for (const WrenchAxis& axis : plan.axes) names.push_back(Name(axis.dof));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string CoupledPlanSentence(const CoupledPlan& plan) {
  if (!plan.IsUsable()) return plan.message;
  const std::string text =
      fmt::format("Command {} for {:g} s as planned.", NamesOfAxes(plan), plan.duration);
  if (!plan.separations.empty()) return text + SeparationSentences(plan.separations);
  std::vector<double> gains;
  std::vector<std::string> open;
  for (const PlannedParameter& entry : plan.parameters) {
    if (std::isinf(entry.after)) {
      open.push_back(entry.name);
    } else if (std::isfinite(entry.sine)) {
      gains.push_back(GainOf(entry));
    }
  }
  std::string more;
  if (!gains.empty()) {
    std::sort(gains.begin(), gains.end());
    more = fmt::format(
        " A sine on one axis after the other, as long, leaves intervals {:.2g} to {:.2g} times as "
        "wide, in the middle {:.2g} times.",
        gains.front(),
        gains.back(),
        gains[gains.size() / 2]);
  }
  if (!open.empty()) {
    more += fmt::format(" By itself it does not tell {}: command the DOFs that these need.",
                        fmt::join(open, ", "));
  }
  return text + more;
}

std::vector<std::string> CoupledPlanComments(const CoupledPlanRequest& request,
                                             const CoupledPlan& plan) {
  std::vector<std::string> amplitudes, held;
  for (const Dof dof : request.model.model.dofs) {
    const bool is_driven = std::any_of(plan.axes.begin(),
                                       plan.axes.end(),
                                       [&](const WrenchAxis& axis) { return axis.dof == dof; });
    if (!is_driven) held.emplace_back(Name(dof));
  }
  for (std::size_t k = 0; k < plan.axes.size(); ++k) {
    const Dof dof = plan.axes[k].dof;
    amplitudes.push_back(
        fmt::format("{} {:.3g} {}", Name(dof), plan.sine_amplitude[k], ForceUnit(dof)));
  }
  std::vector<std::string> comments = {
      fmt::format(
          "95 % of the models that the log allows stay within {}. This counts {:g} s of coasting "
          "behind the command. Of {} models {:.1f} % break a limit.",
          fmt::join(ReachesOf(request.model.model.dofs, plan), ", "),
          kCoastAfterwards,
          plan.num_models,
          100.0 * plan.share_breaking),
      NoiseComment(request, plan),
      fmt::format("The ordinary sines: {} at {:g} rad/s, as much as the limits leave.",
                  fmt::join(amplitudes, ", "),
                  kSineFrequency)};
  for (const WrenchAxis& axis : plan.axes) {
    if (axis.force >= request.limits.force[static_cast<std::size_t>(Index(axis.dof))]) continue;
    comments.push_back(
        fmt::format("More than {:.3g} {} of {} is of no use: one hold of it passes a limit.",
                    axis.force,
                    ForceUnit(axis.dof),
                    Name(axis.dof)));
  }
  if (!request.flown.empty()) comments.emplace_back(kFlownLogsCount);
  if (!held.empty()) {
    comments.push_back(fmt::format("Not commanded: {}.", fmt::join(held, ", ")));
  }
  if (!plan.left_out.empty()) {
    comments.push_back(fmt::format(
        "Left out, since a wrench tells nothing of single thrusters, fins and clocks: {}.",
        fmt::join(plan.left_out, ", ")));
  }
  if (plan.thrusters) {
    const auto add = [&](const std::vector<std::string>& lines) {
      comments.insert(comments.end(), lines.begin(), lines.end());
    };
    add(UseOfThrusters(ThrustsOf(plan.command, *plan.thrusters),
                       plan.thrusters->thrusters(),
                       request.vehicle_name));
    for (std::size_t k = 0; k < plan.axes.size(); ++k) {
      add(MomentsToRight(plan.axes[k].dof, plan.thrusters->along[k]));
    }
  }
  return comments;
}

Table PlannedEntryTable(const CoupledPlan& plan) {
  Table table = PlannedParameterTable(plan.parameters);
  table.columns.back().heading = "after sines";
  return table;
}

Table CoupledSeparationTable(const CoupledPlan& plan) {
  Table table = PlannedSeparationTable(plan.separations);
  table.columns.back().heading = "sines";
  return table;
}

}  // namespace fathom
