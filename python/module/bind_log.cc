// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_fingerprint.h"

#include "module/arrays.h"
#include "module/bindings.h"
#include "module/log_from_arrays.h"
#include "module/logs_argument.h"
#include "module/python_words.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

std::vector<std::string> DofNames(const Log& log) {
  std::vector<std::string> names;
  for (const Dof dof : log.dofs) names.emplace_back(Name(dof));
  return names;
}

py::object StreamDict(const std::optional<Stream>& stream) {
  if (!stream) return py::none();
  return DictOfStream(*stream);
}

std::string StreamLine(const char* name, const std::optional<Stream>& stream) {
  if (!stream) return "";
  return fmt::format("  {}: {}; {} rows, {:.1f} to {:.1f} s\n",
                     name,
                     fmt::join(stream->columns, ", "),
                     stream->time.size(),
                     stream->time.front(),
                     stream->time.back());
}

std::string LogSummary(const OpenedLog& opened) {
  const Log& log = opened.log;
  return fmt::format("Log {}: {}\n", log.name, fmt::join(DofNames(log), ", ")) +
         StreamLine("command", log.command) + StreamLine("velocity", log.velocity) +
         StreamLine("pose", log.pose) + StreamLine("detections", log.detections);
}

OpenedLog OpenInPython(const py::object& path,
                       const std::optional<std::string>& dof,
                       const py::object& velocity,
                       const Pairs& held_out,
                       const NumberByColumn& correct,
                       const NumberByColumn& late) {
  const std::string place = PathOf(path);
  OpenLogArguments arguments;
  if (dof) arguments.dof = ParseArgument("dof", *dof, ParseDof);
  if (!velocity.is_none()) arguments.velocity = PathOf(velocity);
  arguments.held_out = HeldOutText(held_out);
  arguments.held_out_times = HeldOutOf(held_out);
  arguments.corrections = CorrectionsOf(correct, late);
  arguments.corrections_by = correct.empty() ? "late" : late.empty() ? "correct" : "correct, late";
  const py::gil_scoped_release release;
  return OpenPath(place, arguments);
}

std::vector<std::string> NamesOfDofs(const py::object& dof) {
  if (py::isinstance<py::str>(dof)) return {dof.cast<std::string>()};
  return dof.cast<std::vector<std::string>>();
}

}  // namespace

void BindLog(py::module_& module) {
  py::class_<OpenedLog>(module, "Log", "A log: streams on their own clocks. It does not change.")
      .def_property_readonly("name", [](const OpenedLog& log) { return log.log.name; })
      .def_property_readonly("path", [](const OpenedLog& log) { return log.place; })
      .def_property_readonly(
          "dofs", [](const OpenedLog& log) { return DofNames(log.log); }, "The excited ones.")
      .def_property_readonly(
          "command",
          [](const OpenedLog& log) { return StreamDict(log.log.command); },
          "{\"t\": [s], \"tau_surge\": [N], ... \"tau_yaw\": [N m]}, each held until the next; or "
          "None.")
      .def_property_readonly(
          "velocity",
          [](const OpenedLog& log) { return StreamDict(log.log.velocity); },
          "{\"t\": [s], \"u\": [m/s], ... \"r\": [rad/s]} in the body frame, or None.")
      .def_property_readonly(
          "pose",
          [](const OpenedLog& log) { return StreamDict(log.log.pose); },
          "{\"t\": [s], \"x\": [m], ... \"qw\": [-]}, world_from_body, or None.")
      .def_property_readonly(
          "held_out",
          [](const OpenedLog& log) {
            Pairs pairs;
            for (const TimeInterval& held : log.log.held_out)
              pairs.emplace_back(held.from, held.to);
            return pairs;
          },
          "[(from, to)], not to be trained on [s].")
      .def_property_readonly(
          "mass", [](const OpenedLog& log) { return log.log.mass; }, "Of the vehicle, dry [kg].")
      .def_property_readonly(
          "remarks",
          [](const OpenedLog& log) { return InPythonWords(TextsOf(log.log.remarks)); },
          "What the reader passed over, a sentence each.")
      .def_property_readonly("fingerprint",
                             [](const OpenedLog& log) { return FingerprintOf(log.log); })
      .def("__repr__", &LogSummary)
      .def_static(
          "from_arrays",
          [](const py::object& command,
             const py::object& velocity,
             const py::object& pose,
             const py::object& dof,
             const std::string& name,
             const Pairs& held_out,
             std::optional<double> mass,
             const py::object& vehicle,
             const std::string& command_unit,
             const std::string& thruster_unit) {
            return LogFromArrays(command,
                                 velocity,
                                 pose,
                                 {name,
                                  NamesOfDofs(dof),
                                  held_out,
                                  mass,
                                  vehicle.is_none() ? "" : PathOf(vehicle),
                                  command_unit,
                                  thruster_unit});
          },
          py::arg("command") = py::none(),
          py::arg("velocity") = py::none(),
          py::arg("pose") = py::none(),
          py::kw_only(),
          py::arg("dof"),
          py::arg("name") = "arrays",
          py::arg("held_out") = Pairs(),
          py::arg("mass") = py::none(),
          py::arg("vehicle") = py::none(),
          py::arg("command_unit") = "",
          py::arg("thruster_unit") = "",
          "A log of arrays, by the columns of log folders (docs/file_formats.md).\n\n"
          "command   {\"t\": [s], \"tau_surge\": [N], ...} or thruster_1, ... [Hz] with a vehicle\n"
          "velocity  {\"t\": [s], \"u\": [m/s], ...}\n"
          "pose      {\"t\": [s], \"x\": [m], ..., \"qw\": [-]}\n"
          "dof       the excited one, or a list\n"
          "held_out  [(from, to)], not to be trained on [s]\n"
          "mass      of the vehicle, dry [kg]\n"
          "vehicle   path of a vehicle file\n\n"
          "Raises ValueError for what the reader of log folders refuses.");

  module.def("open_log",
             &OpenInPython,
             py::arg("path"),
             py::kw_only(),
             py::arg("dof") = py::none(),
             py::arg("velocity") = py::none(),
             py::arg("held_out") = Pairs(),
             py::arg("correct") = NumberByColumn(),
             py::arg("late") = NumberByColumn(),
             "A log folder, or a CSV with columns t [s], tau [N or N m], v [m/s or rad/s].\n\n"
             "dof       of a single CSV\n"
             "velocity  a CSV in place of the log's velocity.csv\n"
             "held_out  [(from, to)], not to be trained on [s]; in place of log.yaml's\n"
             "correct   {\"r\": -1.0}, factors of columns of the velocity; in place of log.yaml's\n"
             "late      {\"u\": 0.25}, by how long they come too late [s]; likewise\n\n"
             "Raises ValueError, naming file, line and column, for what breaks the format.");
}

}  // namespace fathom
