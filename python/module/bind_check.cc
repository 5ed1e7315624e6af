// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/shell_word.h"
#include "fathom/check/checkup_json.h"
#include "fathom/check/checkup_page.h"
#include "fathom/check/checkup_text.h"
#include "fathom/check/checkup_verdict.h"
#include "fathom/check/log_checkup.h"

#include "module/arguments.h"
#include "module/arrays.h"
#include "module/bindings.h"
#include "module/logs_argument.h"
#include "module/tell.h"
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

LogCheckup CheckInPython(const py::object& log, const std::optional<std::string>& dof) {
  std::optional<Dof> asked;
  if (dof) asked = ParseArgument("dof", *dof, ParseDof);
  std::vector<OpenedLog> logs = LogsOfArgument(log, asked);
  if (logs.size() > 1) throw InputError("log: names several, expected one.");
  CheckUpOptions options{.dof = asked};
  if (const std::string& held_out = logs.front().held_out; !held_out.empty()) {
    options.data_flags = " --held_out=" + ShellWord(held_out);
  }
  const py::gil_scoped_release release;
  return CheckUp(std::move(logs.front().log), options);
}

std::string PageText(const LogCheckup& checkup) {
  return RenderCheckupPage(checkup, OriginInPython({checkup.log}));
}

std::map<std::string, std::string> WhyNotByDof(const LogCheckup& checkup) {
  std::map<std::string, std::string> why_not;
  for (const DofCheckup& dof : checkup.dofs) why_not.emplace(Name(dof.dof), dof.why_not);
  return why_not;
}

}  // namespace

void BindCheck(py::module_& module) {
  py::class_<LogCheckup>(module, "Checkup", "What one should know of a log before a fit.")
      .def_property_readonly("verdict", &Verdict, "What comes first, in a sentence.")
      .def_property_readonly("next_step", &NextStep)
      .def_property_readonly("findings", &AllFindings)
      .def_property_readonly("has_red", &HasRed, "Whether a finding is red.")
      .def_property_readonly(
          "why_not", &WhyNotByDof, "{dof: why it cannot be identified; empty: it can}")
      .def("page", &PageText, "The page of fathom_check --report, HTML.")
      .def(
          "to_dict",
          [](const LogCheckup& checkup) { return DictOfJson(FormatCheckupJson(checkup)); },
          "Schema fathom-check-1: docs/check.md.")
      .def("__repr__", &FormatCheckup)
      .def("_repr_html_", [](const LogCheckup& checkup) { return FrameOf(PageText(checkup)); });

  module.def("check",
             &CheckInPython,
             py::arg("log"),
             py::kw_only(),
             py::arg("dof") = py::none(),
             "What is wrong with a log, and what it can determine, before any fit.\n\n"
             "log  a Log, or a path\n"
             "dof  only this one, or what a single CSV is of");
}

}  // namespace fathom
