// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/starter/starter_texts.h"

#include "fathom/log/proposed_held_out.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

namespace fathom {
namespace {

std::string InDoubleQuotes(const std::string& text) {
  YAML::Emitter yaml;
  yaml << YAML::DoubleQuoted << text;
  return yaml.c_str();
}

std::string ListOf(const std::vector<Dof>& dofs) {
  std::vector<std::string_view> names;
  for (const Dof dof : dofs) names.push_back(Name(dof));
  return fmt::format("[{}]", fmt::join(names, ", "));
}

// "key: value" where the value is known, otherwise "#key: example".
std::string KnownOr(const char* key, const std::string& value, const char* example) {
  return value.empty() ? fmt::format("#{}: {}\n", key, example)
                       : fmt::format("{}: {}\n", key, InDoubleQuotes(value));
}

// Where no span is known, that of an example.
TimeInterval HeldOutOf(const std::optional<TimeInterval>& span) {
  if (!span) return {.from = 240.0, .to = 300.0};
  return OutToTenths(ProposedHeldOut({&*span, 1}));
}

}  // namespace

std::string StarterLogYaml(const KnownOfLog& known) {
  const TimeInterval held_out = HeldOutOf(known.span);
  return fmt::format(
             "# What a log is: docs/file_formats.md. To use a key below, remove the # before it.\n"
             "name: {}\n"
             "# What the log excites: of surge, sway, heave, roll, pitch, yaw.\n"
             "dof: {}\n"
             "\n"
             "# The vehicle file in this folder. Thruster speeds and the checks need it.\n",
             InDoubleQuotes(known.name),
             ListOf(known.dofs)) +
         KnownOr("vehicle", known.vehicle, "vehicle.yaml") +
         fmt::format(
             "# Of the vehicle, dry [kg], in place of the vehicle file's.\n"
             "#mass: 10\n"
             "# Log time not to be trained on, [from, to], to score the model with [s].\n"
             "#held_out: [{:.1f}, {:.1f}]\n"
             "# Where commands are not N and N m. Only ratios of parameters then mean anything.\n"
             "#command_unit: A\n"
             "# Which logs of an archive belong together.\n"
             "#dive: 2026-05-03 harbour\n"
             "# When it began, in UTC. Orders the dives of an archive.\n"
             "#start: 2026-05-03T14:30:00Z\n"
             "# For the reader.\n"
             "#notes: still water, tether slack\n"
             "# The video of a camera log, in this folder.\n",
             held_out.from,
             held_out.to) +
         KnownOr("video", known.video, "camera.mp4");
}

std::string StarterVehicleYaml(const std::string& name, std::size_t num_thrusters) {
  std::string text = fmt::format(
      "# What a vehicle is: docs/file_formats.md. To use a key below, remove the # before it.\n"
      "name: {}\n"
      "# Dry [kg]. The inertia is checked against it.\n"
      "#mass: 10\n"
      "# Length, width, height [m]. They say how much water moves with the vehicle.\n"
      "#size: [0.5, 0.4, 0.3]\n"
      "\n"
      "# Thrust over command, from the maker's data or a test. Commands are pulse widths (us) or\n"
      "# shares of full command (1). A row: command, thrust at each supply voltage [N].\n"
      "#thrust_tables:\n"
      "#- name: my_thruster\n"
      "#  command: us\n"
      "#  voltages: [12, 16]\n"
      "#  thrust:\n"
      "#  - [1100, -30, -40]\n"
      "#  - [1500, 0, 0]\n"
      "#  - [1900, 38, 51]\n"
      "# In the order of thruster_1, thruster_2, ... Position in the body frame (x forward, y\n"
      "# starboard, z down) [m]; direction of positive thrust, of length 1. A thruster whose "
      "command\n"
      "# is its speed in Hz has, in place of thrust_table,\n"
      "# coefficient: {{forward: 0.04, reverse: 0.03}}  [N s^2].\n"
      "#thrusters:\n",
      InDoubleQuotes(name));
  for (std::size_t i = 1; i <= num_thrusters; ++i) {
    text += fmt::format(
        "#- {{name: thruster_{}, position: [-0.2, {}, 0], direction: [1, 0, 0], "
        "thrust_table: my_thruster}}\n",
        i,
        i % 2 == 1 ? "-0.15" : "0.15");
  }
  return text;
}

std::string StarterMapYaml(const std::string& name,
                           const std::optional<TimeInterval>& span,
                           const std::string& suggested) {
  const TimeInterval held_out = HeldOutOf(span);
  return fmt::format(
      "# What a map is: docs/import.md. To use a key below, remove the # before it.\n"
      "name: {}\n"
      "# Of the vehicle, dry [kg], in place of the vehicle file's.\n"
      "#mass: 10\n"
      "# Log time not to be trained on, [from, to], to score the model with [s].\n"
      "#held_out: [{:.1f}, {:.1f}]\n"
      "\n"
      "{}",
      InDoubleQuotes(name),
      held_out.from,
      held_out.to,
      suggested);
}

}  // namespace fathom
