// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/coupled/coupled_text.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/model_file.h"

#include <ranges>

#include "module/arrays.h"
#include "module/bindings.h"
#include "module/logs_argument.h"
#include "module/number.h"
#include "module/python_words.h"
#include "module/tell.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

Table ModelTable(const FittedModel& model) {
  Table table;
  table.columns = {{"parameter"}, {"value", true}, {"unit"}, {"95 % interval", true}};
  for (const IdentifiedNumber& number : NumbersOf(model)) {
    table.rows.push_back({{number.name,
                           FormatValue(number.value, number.std),
                           UnitText(number.unit),
                           FormatInterval(number.value, number.std, number.lower)}});
  }
  return table;
}

std::string FigureLine(const char* part, const FitFigures& figures) {
  if (figures.num_samples == 0) return "";
  return fmt::format("{:<9} velocity NMAE {}\n", part, ShareText(figures.nmae, 4));
}

std::string ModelText(const FittedModel& model) {
  return fmt::format("Model of {}\n", Name(model.dof)) + FormatTable(ModelTable(model)) +
         FigureLine("training", model.train) + FigureLine("held out", model.held_out) +
         NoteLines(model.caveats);
}

std::string CoupledModelText(const FittedCoupledModel& model) {
  return fmt::format(
             "Model of {}\n",
             fmt::join(model.model.dofs | std::views::transform([](Dof dof) { return Name(dof); }),
                       ", ")) +
         FormatTable(CoupledEntryTable(model)) + NoteLines(model.caveats);
}

std::vector<std::string> NamesOf(const std::vector<Dof>& dofs) {
  std::vector<std::string> names;
  for (const Dof dof : dofs) names.emplace_back(Name(dof));
  return names;
}

std::vector<std::string> EffectLabels(const FittedModel& model) {
  std::vector<std::string> labels;
  for (const ActiveEffect& active : model.effects) {
    labels.push_back(LabelOf(active.effect->info(), active.setting));
  }
  return labels;
}

py::dict FiguresByDof(const std::vector<Dof>& dofs, const std::array<FitFigures, 6>& figures) {
  py::dict by_dof;
  for (const Dof dof : dofs) {
    by_dof[py::str(std::string(Name(dof)))] = figures[static_cast<std::size_t>(Index(dof))];
  }
  return by_dof;
}

// A model of one DOF, or of several: what the file says.
py::object ReadModelInPython(const py::object& path) {
  const std::string file = PathOf(path);
  const std::string text = ReadFile(file);
  if (IsCoupledModel(text)) return py::cast(ParseCoupledModel(file, text));
  return py::cast(ParseModel(file, text));
}

void BindModel(py::module_& module) {
  py::class_<FittedModel>(module,
                          "Model",
                          "A model of one DOF:\n\n"
                          "  m dv/dt + d_Q v|v| + d_L v + b = tau    docs/models.md (1)\n\n"
                          "with any effects on top of it.")
      .def_property_readonly("dof", [](const FittedModel& model) { return Name(model.dof); })
      .def_readonly("force_unit", &FittedModel::force_unit, "\"N\", \"N m\", or the log's own.")
      .def_property_readonly(
          "parameters",
          [](const FittedModel& model) { return DictOf(NumbersOf(model)); },
          "{name: Parameter}: inertia [kg or kg m^2], quadratic_damping [kg/m or kg m^2], "
          "linear_damping [kg/s or kg m^2/s], buoyancy [N or N m], then those of the effects.")
      .def_property_readonly("effects", &EffectLabels)
      .def_property_readonly(
          "covariance",
          [](const FittedModel& model) { return ArrayOf(model.covariance); },
          "Of the parameters in their order, in products of their units; NaN where not known.")
      .def_readonly("train", &FittedModel::train)
      .def_readonly("held_out", &FittedModel::held_out)
      .def_property_readonly(
          "caveats",
          [](const FittedModel& model) { return InPythonWords(model.caveats); },
          "What the intervals do not cover.")
      .def_readonly("provenance", &FittedModel::provenance)
      .def(
          "save",
          [](const FittedModel& model, const py::object& path) {
            WriteFile(PathOf(path), FormatModel(model));
          },
          py::arg("path"),
          "Writes a model file, which every tool reads.")
      .def(
          "to_dict",
          [](const FittedModel& model) { return DictOfJson(FormatModel(model)); },
          "The model file as a dict: schema fathom-model-1, docs/file_formats.md.")
      .def("__repr__", &ModelText)
      .def("_repr_html_",
           [](const FittedModel& model) { return NotebookTable(ModelTable(model)); });
}

void BindCoupledModel(py::module_& module) {
  py::class_<FittedCoupledModel>(
      module, "CoupledModel", "A model of several DOFs: docs/coupled.md. Matrices are 6 by 6.")
      .def_property_readonly(
          "dofs", [](const FittedCoupledModel& model) { return NamesOf(model.model.dofs); })
      .def_readonly("structure", &FittedCoupledModel::structure)
      .def_readonly("force_unit", &FittedCoupledModel::force_unit)
      .def_property_readonly(
          "parameters",
          [](const FittedCoupledModel& model) { return DictOf(NumbersOf(model)); },
          "{name: Parameter}, as {\"inertia.surge\": ..., \"linear_damping.sway.yaw\": ...}.")
      .def_property_readonly(
          "covariance", [](const FittedCoupledModel& model) { return ArrayOf(model.covariance); })
      .def_property_readonly(
          "inertia",
          [](const FittedCoupledModel& model) {
            return ArrayOf(Eigen::MatrixXd(model.model.inertia));
          },
          "Rigid body plus added mass [kg], [kg m], [kg m^2]; rows and columns surge to yaw.")
      .def_property_readonly(
          "linear_damping",
          [](const FittedCoupledModel& model) {
            return ArrayOf(Eigen::MatrixXd(model.model.linear_damping));
          },
          "[kg/s], [kg m/s], [kg m^2/s]")
      .def_property_readonly(
          "quadratic_damping",
          [](const FittedCoupledModel& model) {
            return ArrayOf(Eigen::MatrixXd(model.model.quadratic_damping));
          },
          "[kg/m], [kg], [kg m], [kg m^2]")
      .def_property_readonly("train",
                             [](const FittedCoupledModel& model) {
                               return FiguresByDof(model.model.dofs, model.train);
                             })
      .def_property_readonly("held_out",
                             [](const FittedCoupledModel& model) {
                               return FiguresByDof(model.model.dofs, model.held_out);
                             })
      .def_property_readonly(
          "caveats", [](const FittedCoupledModel& model) { return InPythonWords(model.caveats); })
      .def_readonly("provenance", &FittedCoupledModel::provenance)
      .def(
          "save",
          [](const FittedCoupledModel& model, const py::object& path) {
            WriteFile(PathOf(path), FormatCoupledModel(model));
          },
          py::arg("path"),
          "Writes a model file, which every tool reads.")
      .def(
          "to_dict",
          [](const FittedCoupledModel& model) { return DictOfJson(FormatCoupledModel(model)); },
          "The model file as a dict: schema fathom-model-2.")
      .def("__repr__", &CoupledModelText)
      .def("_repr_html_",
           [](const FittedCoupledModel& model) { return NotebookTable(CoupledEntryTable(model)); });
}

}  // namespace

void BindModels(py::module_& module) {
  BindModel(module);
  BindCoupledModel(module);
  module.def(
      "read_model",
      &ReadModelInPython,
      py::arg("path"),
      "A model file, or a verdict file, which holds one: a Model of one DOF, a CoupledModel of "
      "several. Raises ValueError, naming the file and the key.");
}

}  // namespace fathom
