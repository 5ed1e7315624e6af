// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison.h"
#include "fathom/comparison/comparison_file.h"
#include "fathom/comparison/comparison_page.h"
#include "fathom/comparison/recommendation.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/open_log/open_log.h"

#include <algorithm>

#include "module/arguments.h"
#include "module/arrays.h"
#include "module/bindings.h"
#include "module/family_options.h"
#include "module/logs_argument.h"
#include "module/number.h"
#include "module/tell.h"
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

struct ComparedInPython {
  Comparison comparison;
  PageOrigin origin;
};

// A row as Python sees it: fathom.ComparisonRow.
struct ComparedModel {
  Identification row;
  bool is_taken = false;
};

ComparedInPython CompareOpened(const std::vector<OpenedLog>& opened,
                               const ComparisonOptions& options) {
  RequireMotion(opened);
  std::vector<Log> logs = PlainLogs(opened);
  const auto& sources = options.sources;
  const bool is_camera_asked = std::ranges::find(sources, Source::kCamera) != sources.end();
  for (Log& log : logs) {
    if (is_camera_asked) TrackDetections(&log);
    if (sources.empty()) TrackDetectionsIfUsable(&log);
  }
  PageOrigin origin = OriginInPython(logs);
  return {Compare(logs, options), std::move(origin)};
}

ComparedInPython CompareInPython(const py::object& log,
                                 const std::vector<std::string>& dofs,
                                 const std::vector<std::string>& families,
                                 const std::vector<std::string>& sources,
                                 const std::optional<std::vector<double>>& gains,
                                 const std::string& integrator,
                                 double huber,
                                 double shooting_window,
                                 const std::string& weighting) {
  ComparisonOptions options;
  options.dofs = ParseList("dofs", dofs, ParseDof);
  options.families = ParseList("families", families, ParseFamily);
  options.sources = ParseList("sources", sources, ParseSource);
  options.identification = OptionsOf({gains, integrator, huber, shooting_window, weighting});
  const auto only_dof =
      options.dofs.size() == 1 ? std::optional(options.dofs.front()) : std::nullopt;
  const std::vector<OpenedLog> opened = LogsOfArgument(log, only_dof);
  ComparedInPython result = [&] {
    const py::gil_scoped_release release;
    return CompareOpened(opened, options);
  }();
  for (const DofComparison& dof : result.comparison.dofs) WarnOf(dof.findings);
  return result;
}

std::vector<ComparedModel> RowsOf(const ComparedInPython& result) {
  std::vector<ComparedModel> rows;
  for (const DofComparison& dof : result.comparison.dofs) {
    const Identification* const taken = Recommend(dof).taken;
    for (const Identification& row : dof.rows) rows.push_back({row, &row == taken});
  }
  return rows;
}

std::vector<Finding> FindingsOf(const ComparedInPython& result) {
  std::vector<Finding> findings;
  for (const DofComparison& dof : result.comparison.dofs) {
    std::ranges::copy(dof.findings, std::back_inserter(findings));
  }
  return findings;
}

std::string ComparedText(const ComparedInPython& result) {
  std::string text;
  for (const DofComparison& dof : result.comparison.dofs) {
    text += FormatTable(ParameterTable(dof));
    for (const std::string& line : CommentsOn(dof)) text += line + "\n";
    text += "\n";
  }
  return text;
}

std::string ComparedPage(const ComparedInPython& result) {
  Page page = ComparisonPage(result.comparison);
  page.origin = result.origin;
  return RenderPage(page);
}

const FittedModel& RowModel(const ComparedModel& compared) {
  if (!compared.row.is_usable) throw InputError("no usable model: " + compared.row.message);
  return compared.row.fitted;
}

}  // namespace

void BindCompare(py::module_& module) {
  py::class_<ComparedModel>(module, "ComparisonRow", "One family on one source.")
      .def_property_readonly("dof",
                             [](const ComparedModel& row) { return Name(row.row.fitted.dof); })
      .def_property_readonly("family",
                             [](const ComparedModel& row) { return Name(row.row.family); })
      .def_property_readonly("source",
                             [](const ComparedModel& row) { return Name(row.row.source); })
      .def_property_readonly("is_usable",
                             [](const ComparedModel& row) { return row.row.is_usable; })
      .def_readonly(
          "is_taken", &ComparedModel::is_taken, "Whether it is the row to take, marked *.")
      .def_property_readonly("message", [](const ComparedModel& row) { return row.row.message; })
      .def_property_readonly("model",
                             &RowModel,
                             py::return_value_policy::copy,
                             "Raises ValueError where the fit is not usable.")
      .def_property_readonly(
          "parameters", [](const ComparedModel& row) { return DictOf(NumbersOf(RowModel(row))); })
      .def_property_readonly("train", [](const ComparedModel& row) { return row.row.fitted.train; })
      .def_property_readonly("held_out",
                             [](const ComparedModel& row) { return row.row.fitted.held_out; })
      .def("__repr__", [](const ComparedModel& row) {
        return std::string(Name(row.row.fitted.dof)) + ": " + std::string(Name(row.row.family)) +
               ", " + std::string(Name(row.row.source)) + (row.is_taken ? " *" : "");
      });

  py::class_<ComparedInPython>(module, "Comparison", "Families x sources x DOFs on the same data.")
      .def_property_readonly("rows", &RowsOf)
      .def_property_readonly("findings", &FindingsOf)
      .def("page", &ComparedPage, "The page of fathom_compare --report, HTML.")
      .def(
          "to_dict",
          [](const ComparedInPython& result) {
            return DictOfJson(FormatComparison(result.comparison));
          },
          "What fathom_compare --json writes: schema fathom-comparison-1.")
      .def("__repr__", &ComparedText)
      .def("_repr_html_",
           [](const ComparedInPython& result) { return FrameOf(ComparedPage(result)); });

  module.def("compare",
             &CompareInPython,
             py::arg("log"),
             py::kw_only(),
             py::arg("dofs") = std::vector<std::string>(),
             py::arg("families") = std::vector<std::string>(),
             py::arg("sources") = std::vector<std::string>(),
             py::arg("gains") = py::none(),
             py::arg("integrator") = "runge_kutta",
             py::arg("huber") = 3.0,
             py::arg("shooting_window") = 600.0,
             py::arg("weighting") = "plain",
             "Identifier families and sources on one log or several, scored by simulating from the "
             "command alone.\n\n"
             "dofs      default: those that log.yaml names\n"
             "families  of least_squares, adaptive, output_error, joint; default: all that the log "
             "allows\n"
             "sources   of pose_estimator, camera; default: all that every log has\n\n"
             "The others as identify() has them.");
}

}  // namespace fathom
