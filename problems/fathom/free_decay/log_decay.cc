// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/log_decay.h"

#include "fathom/base/files/exists.h"
#include "fathom/base/input_error.h"
#include "fathom/findings/motion_check.h"
#include "fathom/findings/stamp_check.h"
#include "fathom/free_decay/choose_stretches.h"
#include "fathom/signal/signals.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/dof_of_log.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

const std::vector<double>* CommandValues(const Log& log, Dof dof) {
  return log.command ? log.command->Find(ForceColumn(dof)) : nullptr;
}

// The same motion under no force, so that SignalsOf() takes it.
Log WithoutForce(Log log, Dof dof, Source source) {
  const std::vector<double>& time = MotionStream(log, dof, source).time;
  log.command = Stream{.time = {time.front(), time.back()},
                       .columns = {std::string(ForceColumn(dof))},
                       .values = {{0.0, 0.0}}};
  return log;
}

constexpr double kEpoch = 1e6;  // stamps beyond this count from some epoch [s], as HoldOut() has it

bool CountsFromEpoch(double first) { return first > kEpoch; }

// In the log's own time: a small number counts from the first sample of a log with epoch stamps.
// Throws InputError if it is not before the last sample.
std::optional<double> FromIn(const Log& log, const Stream& motion, std::optional<double> from) {
  if (!from) return from;
  const double first = motion.time.front(), last = motion.time.back();
  const bool is_relative = CountsFromEpoch(first) && *from < kEpoch;
  const double at = is_relative ? first + *from : *from;
  if (!(at < last)) {
    throw InputError(
        fmt::format("--decay_from: is {:g}, expected below {:g}, where the motion of {} ends.",
                    *from,
                    is_relative ? last - first : last,
                    log.path.string()));
  }
  return at;
}

struct Choice {
  std::vector<ChosenStretch> stretches;
  std::string note;
};

Choice Choose(const Log& log,
              Dof dof,
              const std::vector<Segment>& train,
              double first,
              std::optional<double> from,
              const std::string& asked) {
  const std::string of_log = log.path.filename().string();
  Choice choice;
  if (CommandValues(log, dof) != nullptr && !IsFreeDecay(log, dof)) {
    choice.stretches = WhereCommandIsZero(train, CommandOf(log, dof), from);
    if (choice.stretches.empty()) return choice;
    choice.note = fmt::format(
        "{}: taken where the command is 0{}. A thruster that still turns there is taken for "
        "nothing: fathom_identify --decay_from=SECONDS leaves it out.",
        of_log,
        from ? fmt::format(", from {} s on", asked) : "");
    return choice;
  }
  const char* const why = log.command ? "the command is 0 throughout" : "there is no command";
  if (from) {
    choice.stretches = FromThenOn(train, *from);
    choice.note =
        fmt::format("{}: {}; taken from {} s on, as --decay_from says.", of_log, why, asked);
    return choice;
  }
  std::vector<ChosenStretch> found = WhereSpeedDecays(train);
  if (found.empty()) return choice;
  const std::size_t others = found.size() - 1;
  choice.stretches = {found.front()};
  choice.note = fmt::format(
      "{}: {}, so that only the motion tells where nothing drives it. Taken is the longest "
      "stretch over which it decays, {}, from where the speed is below 95 % of its peak{}. If it "
      "was still driven there, say when it was let go: fathom_identify --decay_from=SECONDS.",
      of_log,
      why,
      TimesOf(found.front().time, first),
      others == 0 ? "" : fmt::format("; {} more decay", others));
  return choice;
}

void AddStretches(const std::vector<ChosenStretch>& chosen,
                  const std::vector<Segment>& train,
                  DecayOutput output,
                  std::vector<DecayStretch>* stretches) {
  for (const ChosenStretch& stretch : chosen) {
    const Segment& segment = train[stretch.segment];
    const std::vector<double>& motion =
        output == DecayOutput::kVelocity ? segment.velocity : segment.position;
    const auto from = static_cast<std::ptrdiff_t>(stretch.begin);
    const auto to = static_cast<std::ptrdiff_t>(stretch.end);
    stretches->push_back({{segment.time.begin() + from, segment.time.begin() + to},
                          {motion.begin() + from, motion.begin() + to}});
  }
}

// What the logs' vehicle file or mass tells, where they agree on it.
void TakeInertia(std::span<const Log> logs, LogDecay* decay) {
  std::vector<std::optional<double>> inertias, masses;
  for (const Log& log : logs) {
    std::optional<double> inertia;
    const std::filesystem::path file = log.path / log.vehicle;
    if (log.vehicle.ends_with(".yaml") && Exists(file)) {
      inertia = ReadVehicleFile(file).inertia[static_cast<std::size_t>(Index(decay->dof))];
    }
    inertias.push_back(inertia);
    masses.push_back(log.mass);
  }
  const auto agree = [](const auto& values) {
    return std::ranges::all_of(values, [&](const auto& value) { return value == values.front(); });
  };
  if (agree(inertias)) decay->inertia = inertias.front();
  if (!decay->inertia && !IsAngular(decay->dof) && agree(masses)) decay->dry_mass = masses.front();
}

}  // namespace

std::string TimesOf(const TimeInterval& time, double first) {
  const double zero = CountsFromEpoch(first) ? first : 0.0;
  return fmt::format("{:.1f} to {:.1f} s{}",
                     time.from - zero,
                     time.to - zero,
                     zero > 0.0 ? " after its first sample" : "");
}

bool IsFreeDecay(const Log& log, Dof dof) {
  if (!log.command) return true;
  const std::vector<double>* values = CommandValues(log, dof);
  return values != nullptr && std::ranges::all_of(*values, [](double v) { return v == 0.0; });
}

bool AreFreeDecays(std::span<const Log> logs, Dof dof) {
  for (const Log& log : logs) {
    if (!(log.fins || log.shafts) || log.command) continue;
    throw InputError(
        fmt::format("{}: is {}, which a model of one DOF does not hold, expected "
                    "fathom_identify or fathom_diagnose with --dofs: docs/fins.md.",
                    log.path.string(),
                    log.shafts ? "driven by shafts" : "steered by fins alone"));
  }
  const auto driven =
      std::ranges::find_if_not(logs, [&](const Log& log) { return IsFreeDecay(log, dof); });
  if (driven == logs.end()) return true;
  const auto without =
      std::ranges::find_if(logs, [](const Log& log) { return !log.command.has_value(); });
  if (without == logs.end()) return false;
  throw InputError(fmt::format(
      "--log: {} has no command, but {} has one; expected logs of one kind. Take them one by one, "
      "or give fathom_identify --decay_from to take both for free decays.",
      without->path.string(),
      driven->path.string()));
}

LogDecay FitLogDecay(std::span<const Log> logs, const LogDecayOptions& options) {
  if (logs.empty()) throw InputError("A free decay needs at least one log.");
  LogDecay decay;
  decay.dof = DofOfAll(logs, options.dof);
  decay.source = options.source.value_or(BestSourceOf(logs.front(), decay.dof));
  std::vector<std::vector<Segment>> trains;
  std::vector<std::vector<ChosenStretch>> chosen;
  bool has_positions = decay.source == Source::kCamera, oscillates = false;
  for (const Log& log : logs) {
    Signals signals =
        SignalsOf(WithoutForce(log, decay.dof, decay.source), decay.dof, {.source = decay.source});
    if (IsAllHeldOut(signals)) {
      throw InputError(fmt::format("{}: {}", FileOf(log, "log.yaml"), kAllIsHeldOut));
    }
    const Stream& motion = MotionStream(log, decay.dof, decay.source);
    Choice choice = Choose(log,
                           decay.dof,
                           signals.train,
                           motion.time.front(),
                           FromIn(log, motion, options.from),
                           options.from ? fmt::format("{:g}", *options.from) : "");
    if (!choice.note.empty()) decay.notes.push_back(std::move(choice.note));
    for (const ChosenStretch& stretch : choice.stretches) {
      decay.stretches.push_back(stretch.time);
      oscillates |= stretch.oscillates;
    }
    for (const Segment& segment : signals.train) has_positions &= !segment.position.empty();
    trains.push_back(std::move(signals.train));
    chosen.push_back(std::move(choice.stretches));
  }
  decay.output = has_positions ? DecayOutput::kDisplacement : DecayOutput::kVelocity;
  decay.has_stiffness = oscillates || decay.dof == Dof::kRoll || decay.dof == Dof::kPitch;
  TakeInertia(logs, &decay);
  if (decay.stretches.empty()) {
    decay.summary.message = fmt::format(
        "Nothing decays: no stretch of this {} {}. Expected one of 10 samples at least, over which "
        "the vehicle loses a fifth of its speed. fathom_identify --decay_from=SECONDS says where "
        "one "
        "begins.",
        Name(decay.dof),
        options.from ? "is undriven from there on" : "falls from a peak with nothing driving it");
    return decay;
  }
  for (std::size_t k = 0; k < logs.size(); ++k) {
    AddStretches(chosen[k], trains[k], decay.output, &decay.measured);
  }
  FreeDecayOptions fit = options.fit;
  fit.output = decay.output;
  fit.has_stiffness = decay.has_stiffness;
  decay.summary = FitFreeDecay(decay.measured, fit);
  return decay;
}

std::vector<Finding> FindingsOn(std::span<const Log> logs, const LogDecay& decay) {
  std::vector<Finding> findings;
  for (const Log& log : logs) {
    std::ranges::move(CheckStamps(log), std::back_inserter(findings));
    std::ranges::move(CheckMotion(log, decay.dof, decay.source), std::back_inserter(findings));
  }
  return WarningsFirst(std::move(findings));
}

}  // namespace fathom
