// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_text.h"
#include "fathom/free_decay/log_decay.h"

#include <cmath>

#include "module/arguments.h"
#include "module/arrays.h"
#include "module/bindings.h"
#include "module/logs_argument.h"
#include "module/number.h"
#include "module/tell.h"
#include <fmt/format.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

struct DecayInPython {
  LogDecay decay;
  std::vector<Finding> findings;
  std::string places;
};

DecayInPython FitDecay(const py::object& log,
                       const std::optional<std::string>& dof,
                       const std::optional<std::string>& source,
                       const std::optional<double>& decay_from) {
  LogDecayOptions options;
  if (dof) options.dof = ParseArgument("dof", *dof, ParseDof);
  if (source) options.source = ParseArgument("source", *source, ParseSource);
  if (decay_from && !std::isfinite(*decay_from)) {
    throw InputError(fmt::format("decay_from: is {}, expected a time [s].", *decay_from));
  }
  options.from = decay_from;
  const std::vector<OpenedLog> opened = LogsOfArgument(log, options.dof);
  DecayInPython result = [&] {
    const py::gil_scoped_release release;
    RequireMotion(opened);
    const std::vector<Log> logs = PlainLogs(opened);
    DecayInPython fitted = {FitLogDecay(logs, options), {}, PlacesOf(opened)};
    fitted.findings = FindingsOn(logs, fitted.decay);
    return fitted;
  }();
  WarnOf(result.findings);
  return result;
}

std::vector<IdentifiedNumber> DecayNumbers(const DecayInPython& result) {
  std::vector<IdentifiedNumber> numbers;
  if (!result.decay.summary.IsUsable()) return numbers;
  for (const DecayQuantity& quantity : QuantitiesOf(result.decay)) {
    numbers.push_back(
        {quantity.name, quantity.value, quantity.std, quantity.unit, quantity.lower_bound});
  }
  return numbers;
}

}  // namespace

void BindFreeDecay(py::module_& module) {
  py::class_<DecayInPython>(module, "Decay", "What a log tells that nothing drives.")
      .def_property_readonly(
          "is_usable", [](const DecayInPython& result) { return result.decay.summary.IsUsable(); })
      .def_property_readonly(
          "sentence", [](const DecayInPython& result) { return DecaySentence(result.decay); })
      .def_property_readonly(
          "parameters",
          [](const DecayInPython& result) { return DictOf(DecayNumbers(result)); },
          "{name: Parameter}: \"linear_damping / inertia\" [1/s], ...; where the inertia is known, "
          "the parameters too.")
      .def_readonly("findings", &DecayInPython::findings)
      .def(
          "to_dict",
          [](const DecayInPython& result) {
            if (!result.decay.summary.IsUsable()) throw InputError(DecaySentence(result.decay));
            return DictOfJson(FormatDecayJson(result.decay, result.places));
          },
          "What fathom_identify --json writes: schema fathom-decay-1.")
      .def("__repr__", [](const DecayInPython& result) { return FormatDecay(result.decay); })
      .def("_repr_html_",
           [](const DecayInPython& result) { return NotebookTable(QuantityTable(result.decay)); });

  module.def("free_decay",
             &FitDecay,
             py::arg("log"),
             py::kw_only(),
             py::arg("dof") = py::none(),
             py::arg("source") = py::none(),
             py::arg("decay_from") = py::none(),
             "Damping by inertia of a vehicle that coasts down or rolls: docs/free_decay.md.\n\n"
             "decay_from  nothing before it is taken [s]");
}

}  // namespace fathom
