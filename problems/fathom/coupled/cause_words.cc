// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/cause_words.h"

#include "fathom/base/names_of_dofs.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

using Kind = FreeEntry::Kind;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kHardly = 0.15;  // of what it gives, below which an actuator is as good as dead

// "12 +- 3 %", of what the entry is where it has no effect.
std::string ShareWords(const NamedEntry& cause) {
  return WithInterval(100.0 * cause.value / cause.without,
                      100.0 * cause.std / cause.without,
                      "%",
                      -kInfinite,
                      kInfinite);
}

std::string ThrusterWords(const NamedEntry& cause) {
  const char* meaning = "it is weak";
  if (cause.value < -kHardly)
    meaning = "it pushes the wrong way";
  else if (cause.value < kHardly)
    meaning = "it pushes hardly or not at all";
  else if (cause.value > 1.0)
    meaning = "it pushes harder than stated";
  return fmt::format("Thruster {} gives {} of the thrust that the vehicle file states: {}.",
                     cause.entry.actuator,
                     ShareWords(cause),
                     meaning);
}

std::string FinForceWords(const NamedEntry& cause) {
  const double share = cause.value / cause.without;
  const char* meaning = "it does less";
  if (share < -kHardly)
    meaning = "it turns the wrong way";
  else if (share < kHardly)
    meaning = "it is gone, or does hardly anything";
  else if (share > 1.0)
    meaning = "it does more than stated";
  return fmt::format("Fin {} gives {} of the force that the vehicle file states: {}.",
                     cause.entry.actuator,
                     ShareWords(cause),
                     meaning);
}

// "a force in sway", "a moment in yaw".
std::string Acts(Dof row) {
  return fmt::format("{} in {}", IsAngular(row) ? "a moment" : "a force", Name(row));
}

// What stands before the number.
std::string Meaning(const FreeEntry& entry) {
  if (entry.kind == Kind::kFinNeutral) {
    return fmt::format("Fin {} is straight at another angle than 0", entry.actuator);
  }
  if (entry.kind == Kind::kFinStuck) {
    return fmt::format("Fin {} is stuck at one angle, whatever is commanded", entry.actuator);
  }
  if (entry.kind == Kind::kThrustAngle) {
    return "The thrust is turned against the axes of the velocity, above 0 to starboard";
  }
  if (entry.kind == Kind::kTimeOffset) {
    return "Commands act late against the motion, below 0 early";
  }
  if (entry.kind == Kind::kThrusterLag) {
    return "The thrust follows its command with a lag, of this time constant";
  }
  if (entry.kind == Kind::kFinLag) {
    return fmt::format("Fin {} follows its command with a lag, of this time constant",
                       entry.actuator);
  }
  if (entry.kind == Kind::kCurrent) {
    return fmt::format("A current flows {} during {}",
                       entry.row == Dof::kSurge ? "north (below 0 south)" : "east (below 0 west)",
                       entry.actuator);
  }
  if (entry.kind == Kind::kRunOffset) {
    return fmt::format(
        "During {} {} resists that the other logs do not have", entry.actuator, Acts(entry.row));
  }
  if (entry.kind == Kind::kFinRateLimit) {
    return fmt::format("Fin {} turns to its command no faster than this rate", entry.actuator);
  }
  if (entry.kind == Kind::kFinStall) {
    return fmt::format("The lift of fin {} grows no more from this angle of attack on",
                       entry.actuator);
  }
  if (entry.kind == Kind::kInertia) {
    return fmt::format("An acceleration in {} makes {}, and one in {} {}",
                       Name(entry.column),
                       Acts(entry.row),
                       Name(entry.row),
                       Acts(entry.column));
  }
  if (IsEffect(entry)) {
    return fmt::format("In {}, {}",
                       entry.kind == Kind::kEffect ? Name(entry.row) : "every thruster",
                       entry.effect->info().cause);
  }
  return fmt::format("A velocity in {} makes {}", Name(entry.column), Acts(entry.row));
}

std::string NamesOfCauses(const std::vector<NamedEntry>& causes) {
  std::vector<std::string> names;
  for (const NamedEntry& cause : causes) {
    names.push_back(
        fmt::format("{} ({})", NameOf(cause.entry), FormatValue(cause.value, cause.std)));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

// What free runs still miss, or nothing.
std::string MissedWords(const CoupledDiagnosis& diagnosis,
                        const CoupledIdentification& identified) {
  std::vector<std::string> missed;
  for (const Dof dof : diagnosis.missed) {
    const auto at = static_cast<std::size_t>(Index(dof));
    missed.push_back(fmt::format("{} {:.0f} %", Name(dof), 100.0 * diagnosis.run_nmae[at]));
  }
  if (missed.empty()) return "";
  return fmt::format(" Free runs of {:g} s still miss more of the motion than scatter does: {}.",
                     identified.fitted.horizon,
                     fmt::join(missed, ", "));
}

// What to do about a cause; empty where the next run is all.
std::string StepFor(const FreeEntry& entry) {
  switch (entry.kind) {
    case Kind::kThrustGain:
      return fmt::format(
          "Look at thruster {}: propeller, direction, wiring, and its position and coefficient in "
          "the vehicle file.",
          entry.actuator);
    case Kind::kThrustAngle:
      return "Look at what tells the heading, compass or IMU: by this angle it stands askew in the "
             "vehicle, or is deflected. If it does not, the thrusters are turned.";
    case Kind::kTimeOffset:
      return "Compare the stamps of command and motion against one clock.";
    case Kind::kThrusterLag:
      return "Log the propellers' speed and use it in place of the command.";
    case Kind::kRunOffset:
      return fmt::format(
          "Look at what was different in {}: ballast, trim, a tether, the neutral angle of a fin. "
          "The other numbers hold without it.",
          entry.actuator);
    case Kind::kCurrent:
      return fmt::format("The current is that of {} alone. The other numbers hold in still water.",
                         entry.actuator);
    case Kind::kFinLag:
    case Kind::kFinRateLimit:
      return fmt::format("Log the angle that fin {} has and use it in place of the command.",
                         entry.actuator);
    case Kind::kFinForce:
    case Kind::kFinStuck:
      return fmt::format(
          "Look at fin {}: the fin itself, its servo, its linkage, and its area and axis in the "
          "vehicle file.",
          entry.actuator);
    case Kind::kFinStall:
      return fmt::format(
          "Turn fin {} no further against the water than this angle: beyond, it steers no harder "
          "and brakes. If that is early for its shape, look at its leading edge.",
          entry.actuator);
    case Kind::kFinNeutral:
      return fmt::format("Set fin {} straight, or trim its servo by this angle.", entry.actuator);
    default:
      return IsEffect(entry) ? std::string(entry.effect->info().advice) : "";
  }
}

}  // namespace

std::string CauseSentence(const NamedEntry& cause, const std::string& force_unit) {
  std::string text;
  if (cause.entry.kind == Kind::kThrustGain) {
    text = ThrusterWords(cause);
  } else if (cause.entry.kind == Kind::kFinForce) {
    text = FinForceWords(cause);
  } else {
    text = fmt::format("{}: {}.",
                       Meaning(cause.entry),
                       WithInterval(cause.value,
                                    cause.std,
                                    UnitText(UnitOf(cause.entry, force_unit)),
                                    -kInfinite,
                                    kInfinite));
  }
  if (cause.not_told_apart.empty()) return text;
  std::vector<std::string> others;
  for (const FreeEntry& entry : cause.not_told_apart) others.push_back(NameOf(entry));
  return text + fmt::format(" These data cannot tell it from {}.", fmt::join(others, " or "));
}

std::string CoupledVerdictSentence(const CoupledDiagnosis& diagnosis,
                                   const CoupledIdentification& identified) {
  const std::string missed = MissedWords(diagnosis, identified);
  switch (diagnosis.verdict) {
    case Verdict::kConsistent:
      return fmt::format("Nothing beyond the structure `{}` is in the data.",
                         identified.ladder->rungs[identified.ladder->accepted].name);
    case Verdict::kExplained:
    case Verdict::kAmbiguous:
      if (diagnosis.causes.size() == 1) {
        return CauseSentence(diagnosis.causes.front(), identified.fitted.force_unit) + missed;
      }
      return fmt::format("The data show {}{}.{}",
                         NamesOfCauses(diagnosis.causes),
                         diagnosis.verdict == Verdict::kAmbiguous
                             ? ", or in place of some of it others that move the vehicle alike"
                             : "",
                         missed);
    case Verdict::kUnexplained:
      break;
  }
  if (missed.empty()) {
    return "No coupling, no effect and no fault of a thruster or a fin is in the data, but a red "
           "finding speaks against them.";
  }
  return "No coupling, no effect and no fault of a thruster or a fin explains what is missing." +
         missed;
}

std::vector<std::string> CoupledNextSteps(const CoupledDiagnosis& diagnosis,
                                          const std::string& plan_command) {
  std::vector<std::string> steps;
  for (const NamedEntry& cause : diagnosis.causes) {
    std::string step = StepFor(cause.entry);
    // Once of a current's north and east.
    if (!step.empty() && std::ranges::count(steps, step) == 0) steps.push_back(std::move(step));
    if (!cause.not_told_apart.empty() && plan_command.empty()) {
      steps.push_back(fmt::format(
          "To tell {} from the others, drive each thruster and each DOF alone, at several levels.",
          NameOf(cause.entry)));
    }
  }
  if (!diagnosis.missed.empty()) {
    steps.push_back(
        fmt::format("Run fathom_diagnose on {} alone (--dof): more effects of the actuators, the "
                    "water and the sensors are in the models of one DOF.",
                    NamesOf(diagnosis.missed)));
  }
  if (std::ranges::any_of(diagnosis.findings,
                          [](const Finding& f) { return f.severity == Severity::kWarning; })) {
    steps.push_back("Mend what the red findings name, and diagnose the logs again.");
  }
  if (!plan_command.empty()) {
    steps.push_back("To plan the run that tells them apart, with a limits file of the place: " +
                    plan_command);
  }
  if (steps.empty()) {
    steps.push_back("Use the model within the speeds and commands of these data.");
  }
  return steps;
}

}  // namespace fathom
