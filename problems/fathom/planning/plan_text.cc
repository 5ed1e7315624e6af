// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_text.h"

#include "fathom/base/interval95.h"
#include "fathom/planning/planned_motion.h"
#include "fathom/planning/thruster_text.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// "± 0.021": half a 95 % interval; "open" where nothing is known.
std::string HalfWidth(double std) {
  if (!std::isfinite(std)) return "open";
  return "± " + RoundedAt(kStdsOf95 * std, DecimalsFor(kStdsOf95 * std) + 1);
}

// "± 13 %" of the value.
std::string HalfShare(double std, double value) {
  if (!std::isfinite(std)) return "open";
  const double percent = 100.0 * kStdsOf95 * std / std::abs(value);
  return fmt::format("± {} %", RoundedAt(percent, std::max(0, DecimalsFor(percent))));
}

// The parameter that will be known least, in shares of itself; offsets of the force, which have no
// size of their own, do not count. Null if there is none.
const PlannedParameter* WeakestOf(const ExperimentPlan& plan) {
  const PlannedParameter* weakest = nullptr;
  const auto share = [](const PlannedParameter& parameter) {
    return parameter.after / std::abs(parameter.value);
  };
  for (const PlannedParameter& parameter : plan.parameters) {
    if (parameter.name == kParameterInfo[kBuoyancy].name || parameter.value == 0.0) continue;
    if (weakest == nullptr || share(parameter) > share(*weakest)) weakest = &parameter;
  }
  return weakest;
}

std::string Sigmas(double value) { return fmt::format("{:.1f}", value); }

// Which causes velocities cannot tell apart, and whether positions would.
std::string OpenSentence(const PlanRequest& request, const ExperimentPlan& plan) {
  std::vector<std::string> open;
  bool positions_decide = true, positions_help = false;
  double least = std::numeric_limits<double>::infinity();
  for (const PlannedSeparation& pair : plan.separations) {
    if (pair.IsDecided()) continue;
    open.push_back(
        fmt::format("{} from {} ({} sigma)", pair.assumed, pair.truth, Sigmas(pair.sigmas)));
    positions_decide = positions_decide && pair.PositionsDecide();
    if (!pair.PositionsDecide()) continue;
    positions_help = true;
    least = std::min(least, pair.with_positions);
  }
  if (open.empty()) return "";
  std::string text = fmt::format(
      " It cannot tell {}: no run of this kind within these limits was found that does.",
      fmt::join(open, ", nor "));
  if (!positions_help) return text;
  const Dof dof = request.model.dof;
  return text + fmt::format(
                    " Log the position too, as by a camera and markers: known to {:g} {} at each "
                    "velocity, it tells {} of them apart at {} sigma or more.",
                    AdvisedPositionNoise(dof),
                    DisplacementUnit(dof),
                    positions_decide ? "all" : "some",
                    Sigmas(least));
}

std::string SeparationSentence(const PlanRequest& request, const ExperimentPlan& plan) {
  const std::string text = OpenSentence(request, plan);
  double least = std::numeric_limits<double>::infinity(), of_sine = least;
  for (const PlannedSeparation& pair : plan.separations) {
    if (!pair.IsDecided()) continue;
    least = std::min(least, pair.sigmas);
    of_sine = std::min(of_sine, pair.sine);
  }
  if (std::isinf(least)) return text;
  return text + fmt::format(
                    " {} causes are told apart at {} sigma or more; an ordinary sine gives "
                    "{} or more.",
                    text.empty() ? "All" : "All other",
                    Sigmas(least),
                    Sigmas(of_sine));
}

// "-2.9 to 4.6 m"; the limit beside it where there is one.
std::string RangeText(const ValueRange& range, const ValueRange& limit, std::string_view unit) {
  std::string text = fmt::format("{:.2f} to {:.2f} {}", range.low, range.high, unit);
  const auto end = [](double value) {
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : "any";
  };
  if (std::isfinite(limit.low) || std::isfinite(limit.high)) {
    text += fmt::format(" (limits {} to {})", end(limit.low), end(limit.high));
  }
  return text;
}

}  // namespace

std::string PlanSentence(const PlanRequest& request, const ExperimentPlan& plan) {
  if (!plan.IsUsable()) return plan.message;
  const std::string text =
      fmt::format("Command {} for {:g} s as planned.", Name(request.model.dof), plan.duration);
  if (!plan.separations.empty()) return text + SeparationSentence(request, plan);
  const PlannedParameter* weakest = WeakestOf(plan);
  if (weakest == nullptr) return text;
  if (weakest->after > weakest->before) {
    return text + fmt::format(
                      " Of {}, this run alone tells less than what is known already: {}, and not "
                      "{}; both together {}. A longer run tells more.",
                      weakest->name,
                      HalfShare(weakest->after, weakest->value),
                      HalfShare(weakest->before, weakest->value),
                      HalfShare(weakest->with_log_so_far, weakest->value));
  }
  return text + fmt::format(
                    " The least known parameter is {}: {} so far, {} by this run alone, {} by "
                    "both; an ordinary sine of that length gives {}.",
                    weakest->name,
                    HalfShare(weakest->before, weakest->value),
                    HalfShare(weakest->after, weakest->value),
                    HalfShare(weakest->with_log_so_far, weakest->value),
                    HalfShare(weakest->sine, weakest->value));
}

std::vector<std::string> PlanComments(const PlanRequest& request, const ExperimentPlan& plan) {
  const Dof dof = request.model.dof;
  const double speed = request.limits.speed;
  std::vector<std::string> comments = {
      fmt::format(
          "95 % of the models that the log allows stay within {} and {}. This counts {:g} s of "
          "coasting behind the command. Of {} models {:.1f} % break a limit.",
          RangeText(plan.speed_range, {-speed, speed}, VelocityUnit(dof)),
          RangeText(plan.distance_range, request.limits.distance, DisplacementUnit(dof)),
          kCoastAfterwards,
          plan.num_models,
          100.0 * plan.share_breaking),
      fmt::format("The intervals hold for {} noise of {:.2g} {} on {:.3g} velocities a second{}{}.",
                  ColourOf(request).empty() ? "white" : "coloured",
                  plan.measurement.noise,
                  VelocityUnit(dof),
                  plan.measurement.rate,
                  std::isnan(request.limits.velocity.noise) ? ", as large as the log shows"
                                                            : ", as the limits file says",
                  ColourOf(request).empty() ? "; coloured noise widens them" : ""),
      fmt::format("The ordinary sine: {:.3g} {} at {:g} rad/s, as much as the limits leave.",
                  plan.sine.amplitude,
                  ForceUnit(dof),
                  kSineFrequency)};
  if (std::isfinite(request.limits.position.noise) && !plan.separations.empty()) {
    comments.push_back(
        fmt::format("Positions known to {:g} {} count where causes are told apart, not in the "
                    "intervals.",
                    request.limits.position.noise,
                    DisplacementUnit(dof)));
  }
  if (request.limits_are_of_log) {
    comments.push_back(fmt::format(
        "No limits file was given: force and speed are at most those of the log, {:.3g} {} and "
        "{:.3g} {}, and the distance is not limited. In a tank or on a tether give --limits.",
        request.limits.force,
        ForceUnit(dof),
        speed,
        VelocityUnit(dof)));
  }
  if (plan.force < request.limits.force) {
    comments.push_back(fmt::format(
        "More than {:.3g} {} is of no use: one hold of it passes the limits of speed or distance.",
        plan.force,
        ForceUnit(dof)));
  }
  if (!request.flown.empty()) comments.emplace_back(kFlownLogsCount);
  if (request.thrusters) {
    const ThrusterAllocation& allocation = *request.thrusters;
    const PlannedThrusts thrusts = ThrustsOf(plan.command, allocation);
    for (const auto& lines : {UseOfThrusters(thrusts, allocation.thrusters, request.vehicle),
                              MomentsToRight(dof, allocation)}) {
      comments.insert(comments.end(), lines.begin(), lines.end());
    }
  }
  if (!plan.led_by.empty()) {
    comments.push_back(fmt::format("Intervals and limits are those of the cause {}.", plan.led_by));
  }
  if (!plan.breaking_rivals.empty()) {
    comments.push_back(
        fmt::format("If the cause is {}, the vehicle passes a limit: be ready to stop.",
                    fmt::join(plan.breaking_rivals, " or ")));
  }
  return comments;
}

Table PlannedParameterTable(const std::vector<PlannedParameter>& parameters) {
  Table table = {.caption = "95 % intervals",
                 .columns = {{"parameter"},
                             {"value so far", true},
                             {"before", true},
                             {"after the plan", true},
                             {"with the log so far", true, 1},
                             {"after a sine", true}},
                 .rows = {}};
  for (const PlannedParameter& parameter : parameters) {
    table.rows.push_back({{fmt::format("{} [{}]", parameter.name, UnitText(parameter.unit)),
                           FormatValue(parameter.value),
                           HalfWidth(parameter.before),
                           HalfWidth(parameter.after),
                           HalfWidth(parameter.with_log_so_far),
                           HalfWidth(parameter.sine)}});
  }
  return table;
}

Table PlannedSeparationTable(const std::vector<PlannedSeparation>& separations) {
  Table table = {
      .caption = "How far a wrong cause will miss, in standard deviations",
      .columns = {{"if it is"}, {"and one assumes"}, {"the plan", true}, {"a sine", true}},
      .rows = {}};
  for (const PlannedSeparation& separation : separations) {
    table.rows.push_back({{separation.truth,
                           separation.assumed,
                           Sigmas(separation.sigmas),
                           Sigmas(separation.sine)}});
  }
  return table;
}

}  // namespace fathom
