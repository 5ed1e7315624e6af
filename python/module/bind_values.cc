// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/finding.h"
#include "fathom/vehicle/fitted_model.h"

#include "module/bindings.h"
#include "module/number.h"
#include <fmt/format.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

const char* SeverityName(const Finding& finding) {
  return finding.severity == Severity::kWarning ? "red" : "yellow";
}

}  // namespace

void BindValues(py::module_& module) {
  py::class_<IdentifiedNumber>(module, "Parameter", "A number that was identified.")
      .def_readonly("name", &IdentifiedNumber::name)
      .def_readonly("value", &IdentifiedNumber::value, "In `unit`.")
      .def_readonly("std", &IdentifiedNumber::std, "Standard deviation, in `unit`; NaN: not known.")
      .def_readonly("unit", &IdentifiedNumber::unit, "\"kg\", \"kg m^2/s\", \"-\" for none.")
      .def_property_readonly(
          "interval", &IdentifiedNumber::Interval, "95 % interval (low, high), in `unit`.")
      .def("__float__", [](const IdentifiedNumber& number) { return number.value; })
      .def("__repr__", &IdentifiedNumber::Text);

  py::class_<FitFigures>(module, "Figures", "How far free runs are from the measured velocity.")
      .def_readonly("mae", &FitFigures::mae, "Mean absolute error [m/s] or [rad/s].")
      .def_readonly("nmae", &FitFigures::nmae, "The same over the mean speed [-].")
      .def_readonly("n", &FitFigures::num_samples, "Samples.")
      .def_readonly("duration", &FitFigures::duration, "[s]")
      .def("__repr__", [](const FitFigures& figures) {
        return fmt::format("Figures(mae={:.5g}, nmae={:.4g}, n={}, duration={:.1f})",
                           figures.mae,
                           figures.nmae,
                           figures.num_samples,
                           figures.duration);
      });

  py::class_<Finding>(module, "Finding", "What is odd about a log, or about a model of it.")
      .def_property_readonly("severity", &SeverityName, "\"red\" or \"yellow\".")
      .def_readonly("code", &Finding::code, "One word for programs; docs/findings.md.")
      .def_readonly("sentence", &Finding::sentence)
      .def("__repr__", [](const Finding& finding) {
        return fmt::format("{}: {}", SeverityName(finding), finding.sentence);
      });
}

}  // namespace fathom
