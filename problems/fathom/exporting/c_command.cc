// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/c_command.h"

#include "fathom/base/input_error.h"
#include "fathom/exporting/c_functions.h"
#include "fathom/exporting/comment_text.h"
#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/vehicle/coupled/fin_force.h"
#include "fathom/vehicle/fin.h"
#include "fathom/vehicle/shaft.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// The fins of the vehicle file whose force the model has, in its order.
std::vector<Fin> FinsOf(const ExportModel& model, const ExportTarget& target) {
  std::vector<Fin> fins;
  if (target.vehicle) {
    for (const Fin& fin : target.vehicle->fins) {
      if (HasNumber(model, FinForceEntry(fin.name))) fins.push_back(fin);
    }
  }
  for (const ExportNumber& number : model.numbers) {
    const FreeEntry& entry = number.entry;
    if (entry != FinForceEntry(entry.actuator)) continue;
    if (std::ranges::find(fins, entry.actuator, &Fin::name) != fins.end()) continue;
    throw InputError(
        fmt::format("{}: {}, expected the file that says where the model's fin {} stands.",
                    NameOfVehicleFile(target),
                    target.vehicle ? "has no fin of that name" : "is missing",
                    entry.actuator));
  }
  return fins;
}

std::vector<Shaft> ShaftsOf(const ExportTarget& target) {
  return target.vehicle ? target.vehicle->shafts : std::vector<Shaft>();
}

// The shafts in whose race a fin stands.
std::vector<std::size_t> ShaftsBefore(const Fin& fin, const Vehicle& vehicle) {
  CoupledCommand command;
  for (const Thruster& thruster : vehicle.thrusters) command.thrusters.push_back({thruster.name});
  for (const Shaft& shaft : vehicle.shafts) command.shafts.push_back(CommandedShaftOf(shaft));
  CommandedFin commanded;
  commanded.behind = fin.behind;
  return RaceShafts(command, commanded);
}

bool StandsInRace(const ExportModel& model, const Fin& fin) {
  return !fin.behind.empty() && HasNumber(model, FinRaceEntry(fin.name));
}

template <typename T>
std::string NamesIn(const std::vector<T>& actuators) {
  std::vector<std::string> names;
  for (const T& actuator : actuators) names.push_back(CommentText(actuator.name));
  return fmt::to_string(fmt::join(names, ", "));
}

std::string Row(const std::vector<double>& values) {
  std::vector<std::string> literals;
  for (const double value : values) literals.push_back(LiteralOf(value + 0.0));  // no -0
  return fmt::format("{{{}}}", fmt::join(literals, ", "));
}

std::string Row(const Vector6& values) {
  return Row(std::vector<double>(values.begin(), values.end()));
}

std::string Struct(const std::vector<Fin>& fins,
                   const std::vector<Shaft>& shafts,
                   bool has_race,
                   const std::string& name) {
  std::string text = fmt::format(
      "/* What drives the vehicle. Begin with {{{{0}}}}. */\n"
      "typedef struct {{\n"
      "  double tau[6]; /* forces and moments beside fins and shafts [N], [N m] */\n");
  if (!fins.empty()) {
    text += fmt::format("  double fin[{}]; /* angles of {} [rad] */\n", fins.size(), NamesIn(fins));
  }
  if (has_race) {
    text += fmt::format(
        "  double race[{}]; /* the thrust ahead in whose race each stands, as far as tau holds it "
        "[N] */\n",
        fins.size());
  }
  if (!shafts.empty()) {
    text += fmt::format("  double shaft[{}]; /* revolutions of {}, above 0 ahead [Hz] */\n",
                        shafts.size(),
                        NamesIn(shafts));
  }
  return text + fmt::format("}} {}_command;\n\n", name);
}

std::string Propeller(const std::string& name) {
  return fmt::format(
      "/* T = rho n |n| D^4 K_T(J), J = (1 - w) u / (n D), between points of the curve on straight "
      "lines. */\n"
      "static inline double {0}_propeller(const double *J, const double *K_T, int num, double D,\n"
      "                                   double w, double n, double u) {{\n"
      "  const double advance = n == 0.0 ? 0.0 : (1.0 - w) * u / (n * D);\n"
      "  double slope = 0.0, at_rest = K_T[0];\n"
      "  int k = 1;\n"
      "  if (num > 1 && advance >= 0.0) {{\n"
      "    while (k < num - 1 && J[k] <= advance) ++k;\n"
      "    slope = (K_T[k] - K_T[k - 1]) / (J[k] - J[k - 1]);\n"
      "    at_rest = K_T[k] - slope * J[k];\n"
      "  }}\n"
      "  return 1000.0 * D * D * D * fabs(n) * (D * at_rest * n + slope * (1.0 - w) * u);\n"
      "}}\n"
      "\n",
      name);
}

std::string Stalled(const std::string& name) {
  return fmt::format(
      "/* What stall leaves of the sine y of an angle of attack; L is that of the angle at which a "
      "fin "
      "stalls. */\n"
      "static inline double {0}_stalled(double y, double L) {{\n"
      "  const double beyond = fabs(y) - 0.9 * L;\n"
      "  if (beyond <= 0.0) return y;\n"
      "  return copysign(beyond < 0.2 * L ? fabs(y) - beyond * beyond / (0.4 * L) : L, y);\n"
      "}}\n"
      "\n",
      name);
}

// With `stalls` each fin has the sine of the angle at which it stalls.
std::string AddFin(bool stalls, const std::string& name) {
  return fmt::format(
      "/* F_N = f V (s sin(angle) - w cos(angle)), V^2 = s^2 + w^2, s^2 = u^2 + race. */\n"
      "static inline void {0}_add_fin(double f, double angle, double race, {1}const double "
      "along[6],\n"
      "                               const double across[6], const double nu[6], double tau[6]) "
      "{{\n"
      "  const double sine = sin(angle), cosine = cos(angle);\n"
      "  double u = 0.0, w = 0.0, s, {2}load;\n"
      "  int i;\n"
      "  for (i = 0; i < 6; ++i) {{\n"
      "    u += along[i] * nu[i];\n"
      "    w += across[i] * nu[i];\n"
      "  }}\n"
      "  s = race != 0.0 ? sqrt(fmax(u * u + race, 1e-9)) : u;\n"
      "{3}"
      "  for (i = 0; i < 6; ++i) tau[i] += load * (cosine * across[i] - sine * along[i]);\n"
      "}}\n"
      "\n",
      name,
      stalls ? "double L, " : "",
      stalls ? "V, " : "",
      stalls ? fmt::format("  V = hypot(s, w);\n"
                           "  if (V == 0.0) return;\n"
                           "  load = f * V * V * {}_stalled((s * sine - w * cosine) / V, L);\n",
                           name)
             : "  load = f * hypot(s, w) * (s * sine - w * cosine);\n");
}

// tau += what shaft k gives; its thrust stays in thrust[k].
std::string ForceOfShaft(const ExportModel& model,
                         const Shaft& shaft,
                         std::size_t k,
                         const std::string& name) {
  const CommandedShaft commanded = CommandedShaftOf(shaft);
  const OpenWaterCurve curve = shaft.curve.value_or(OpenWaterCurve{{0.0}, {1.0}});
  const FreeEntry gain = ThrustGainEntry(shaft.name);
  const bool has_gain = HasNumber(model, gain);
  return fmt::format(
      "  {{ /* {0} */\n"
      "    static const double J[{1}] = {2}, K_T[{1}] = {3}, push[6] = {4};\n"
      "    double u = 0.0;\n"
      "    for (i = 0; i < 6; ++i) u += push[i] * nu[i];\n"
      "    thrust[{5}] = {6}_propeller(J, K_T, {1}, {7}, {8}, command->shaft[{5}], u);\n"
      "    for (i = 0; i < 6; ++i) tau[i] += {9}{10} * thrust[{5}] * push[i];\n"
      "  }}\n",
      CommentText(shaft.name),
      curve.advance.size(),
      Row(curve.advance),
      Row(curve.thrust),
      Row(commanded.push),
      k,
      name,
      LiteralOf(shaft.diameter),
      LiteralOf(shaft.wake.value_or(0.0)),
      has_gain ? MacroOf(model, gain, name) + " * " : "",
      LiteralOf(1.0 - shaft.thrust_deduction.value_or(0.0)));
}

// "BOAT_FIN_RACE_1 * fmax(command->race[0] + thrust[0], 0.0)", "0.0" outside of a race.
std::string RaceOf(const ExportModel& model,
                   const Fin& fin,
                   std::size_t k,
                   const ExportTarget& target) {
  if (!StandsInRace(model, fin)) return "0.0";
  std::string sum = fmt::format("command->race[{}]", k);
  for (const std::size_t shaft : ShaftsBefore(fin, *target.vehicle)) {
    sum += fmt::format(" + thrust[{}]", shaft);
  }
  return fmt::format(
      "{} * fmax({}, 0.0)", MacroOf(model, FinRaceEntry(fin.name), target.name), sum);
}

std::string AngleOf(const ExportModel& model,
                    const Fin& fin,
                    std::size_t k,
                    const std::string& name) {
  if (HasNumber(model, FinStuckEntry(fin.name))) {
    return MacroOf(model, FinStuckEntry(fin.name), name);
  }
  const bool is_straight = !HasNumber(model, FinNeutralEntry(fin.name));
  return fmt::format("command->fin[{}]{}",
                     k,
                     is_straight ? "" : " - " + MacroOf(model, FinNeutralEntry(fin.name), name));
}

bool Stalls(const ExportModel& model, const Fin& fin) {
  return HasNumber(model, FinStallEntry(fin.name));
}

// "sin(BOAT_FIN_STALL_1), ".
std::string LimitOf(const ExportModel& model, const Fin& fin, const std::string& name) {
  if (!Stalls(model, fin)) return "HUGE_VAL, ";
  return fmt::format("sin({}), ", MacroOf(model, FinStallEntry(fin.name), name));
}

// `stalls`: some fin of the model does.
std::string ForceOfFin(const ExportModel& model,
                       const Fin& fin,
                       std::size_t k,
                       bool stalls,
                       const ExportTarget& target) {
  const std::string& name = target.name;
  const FinArms arms = ArmsOf(fin);
  return fmt::format(
      "  {{ /* {} */\n"
      "    static const double along[6] = {};\n"
      "    static const double across[6] = {};\n"
      "    {}_add_fin({}, {},\n"
      "        {}, {}along, across, nu, tau);\n"
      "  }}\n",
      CommentText(fin.name),
      Row(arms.along),
      Row(arms.across),
      name,
      MacroOf(model, FinForceEntry(fin.name), name),
      AngleOf(model, fin, k, name),
      RaceOf(model, fin, k, target),
      stalls ? LimitOf(model, fin, name) : "");
}

std::string Turn(const std::string& name) {
  return fmt::format(
      "/* From *angle to an order at a rate, over h [s]: the mean, *angle at the end. */\n"
      "static inline double {0}_turn(double order, double rate, double h, double *angle) {{\n"
      "  const double begin = *angle, way = order - begin, needed = fabs(way) / rate;\n"
      "  if (needed > h) {{\n"
      "    *angle = begin + copysign(rate * h, way);\n"
      "    return 0.5 * (begin + *angle);\n"
      "  }}\n"
      "  *angle = order;\n"
      "  return order - 0.5 * way * needed / h;\n"
      "}}\n"
      "\n",
      name);
}

// The mean angle of fin k, and where it then is.
std::string MeanAngleOf(const ExportModel& model,
                        const Fin& fin,
                        std::size_t k,
                        const std::string& name) {
  const auto follows = [&](const char* how, const FreeEntry& by) {
    return fmt::format("  mean[{0}] = {1}_{2}(order[{0}], {3}, h, &angle[{0}]);\n",
                       k,
                       name,
                       how,
                       MacroOf(model, by, name));
  };
  const FreeEntry lag = FinLagEntry(fin.name), rate = FinRateLimitEntry(fin.name);
  if (HasNumber(model, lag)) return follows("lag", lag);
  if (HasNumber(model, rate)) return follows("turn", rate);
  return fmt::format("  mean[{0}] = angle[{0}] = order[{0}];\n", k);
}

}  // namespace

CCommand CommandInC(const ExportModel& model, const ExportTarget& target) {
  const std::string& name = target.name;
  const std::vector<Fin> fins = FinsOf(model, target);
  const std::vector<Shaft> shafts = ShaftsOf(target);
  if (fins.empty() && shafts.empty()) return {"", "const double tau[6]", "tau"};
  const bool has_race =
      std::ranges::any_of(fins, [&](const Fin& fin) { return StandsInRace(model, fin); });
  std::string text = Struct(fins, shafts, has_race, name);
  if (!shafts.empty()) text += Propeller(name);
  const bool stalls = std::ranges::any_of(fins, [&](const Fin& fin) { return Stalls(model, fin); });
  if (stalls) text += Stalled(name);
  if (!fins.empty()) text += AddFin(stalls, name);
  text += fmt::format(
      "/* What fins, shafts and the rest of the command give at a velocity [N], [N m]. */\n"
      "static inline void {0}_command_forces(const double nu[6], const {0}_command *command,\n"
      "                                      double tau[6]) {{\n"
      "{1}"
      "  int i;\n"
      "  for (i = 0; i < 6; ++i) tau[i] = command->tau[i];\n",
      name,
      shafts.empty() ? "" : fmt::format("  double thrust[{}];\n", shafts.size()));
  for (std::size_t k = 0; k < shafts.size(); ++k) text += ForceOfShaft(model, shafts[k], k, name);
  for (std::size_t k = 0; k < fins.size(); ++k) {
    text += ForceOfFin(model, fins[k], k, stalls, target);
  }
  return {text + "}\n\n", fmt::format("const {}_command *command", name), "command"};
}

std::string CFinAngles(const ExportModel& model, const ExportTarget& target) {
  const std::vector<Fin> fins = FinsOf(model, target);
  const auto turns = [&](const Fin& fin) { return HasNumber(model, FinRateLimitEntry(fin.name)); };
  const auto follows = [&](const Fin& fin) {
    return turns(fin) || HasNumber(model, FinLagEntry(fin.name));
  };
  if (std::ranges::none_of(fins, follows)) return "";
  std::string text = std::ranges::any_of(fins, turns) ? Turn(target.name) : "";
  text += fmt::format(
      "/* The mean angles over the next h [s] of fins that follow an order that is held so "
      "long, for\n"
      " * {0}_command.fin; `angle` moves on to where they then are [rad]. */\n"
      "static inline void {0}_fin_angles(const double order[{1}], double h, double angle[{1}],\n"
      "                                  double mean[{1}]) {{\n",
      target.name,
      fins.size());
  for (std::size_t k = 0; k < fins.size(); ++k) {
    text += MeanAngleOf(model, fins[k], k, target.name);
  }
  return text + "}\n\n";
}

}  // namespace fathom
