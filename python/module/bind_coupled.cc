// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/cause_words.h"
#include "fathom/coupled/coupled_page.h"
#include "fathom/coupled/coupled_text.h"
#include "fathom/coupled/coupled_verdict_file.h"
#include "fathom/findings/log_check.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/files/coupled_model_file.h"

#include "module/arrays.h"
#include "module/bindings.h"
#include "module/coupled_options.h"
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

struct CoupledInPython {
  CoupledIdentification identified;
  std::vector<Finding> findings;
  PageOrigin origin;
};

struct DiagnosedTogether {
  CoupledInPython fit;
  CoupledDiagnosis diagnosis;
};

// Warns of red findings before the fit, which takes a while.
CoupledInPython FitTogether(const py::object& log,
                            const CoupledIdentificationOptions& options,
                            const std::string& structure,
                            const std::vector<std::string>& free) {
  const std::vector<OpenedLog> opened = LogsOfArgument(log, std::nullopt);
  CoupledInPython result;
  {
    const py::gil_scoped_release release;
    RequireMotion(opened);
    result.findings = CheckLogs(PlainLogs(opened), options.dofs);
    result.origin = OriginInPython(PlainLogs(opened));
  }
  WarnOf(result.findings);
  const py::gil_scoped_release release;
  result.identified = IdentifyCoupled(PlainLogs(opened), options);
  result.identified.fitted.provenance = {{"log", PlacesOf(opened)},
                                         {"velocity", opened.front().velocity},
                                         {"held_out", opened.front().held_out},
                                         {"structure", structure},
                                         {"window", fmt::format("{}", options.fit.window)},
                                         {"version", FATHOM_VERSION}};
  if (!free.empty()) {
    result.identified.fitted.provenance["free"] = fmt::to_string(fmt::join(free, ","));
  }
  return result;
}

CoupledInPython IdentifyTogether(const py::object& log,
                                 const std::vector<std::string>& dofs,
                                 const std::string& structure,
                                 const std::vector<std::string>& free,
                                 double window) {
  return FitTogether(log, CoupledOptions(dofs, structure, free, window), structure, free);
}

DiagnosedTogether DiagnoseTogether(const py::object& log,
                                   const std::vector<std::string>& dofs,
                                   double window) {
  DiagnosedTogether result = {
      FitTogether(log, CoupledOptions(dofs, "auto", {}, window), "auto", {}), {}};
  if (!result.fit.identified.is_usable) {
    throw InputError("no diagnosis: " + result.fit.identified.message + ".");
  }
  result.diagnosis = DiagnoseCoupled(result.fit.identified, result.fit.findings);
  return result;
}

const FittedCoupledModel& UsableCoupledModel(const CoupledInPython& result) {
  const CoupledIdentification& identified = result.identified;
  if (!identified.is_usable) throw InputError("no usable model: " + identified.message + ".");
  return identified.fitted;
}

std::string CoupledText(const CoupledInPython& result) {
  const CoupledIdentification& identified = result.identified;
  const std::string text = identified.is_usable ? FormatCoupledIdentification(identified)
                                                : "no usable model: " + identified.message + ".\n";
  return text + NoteLines(identified.remarks);
}

std::string SentenceOf(const DiagnosedTogether& result) {
  return CoupledVerdictSentence(result.diagnosis, result.fit.identified);
}

std::string DiagnosedText(const DiagnosedTogether& result) {
  std::string text = fmt::format("{}: {}\n", Name(result.diagnosis.verdict), SentenceOf(result));
  text += "\n" + FormatCoupledIdentification(result.fit.identified) + "\n";
  for (const std::string& step : CoupledNextSteps(result.diagnosis)) text += "next: " + step + "\n";
  return text + NoteLines(result.fit.identified.remarks);
}

std::string DiagnosedPage(const DiagnosedTogether& result) {
  Page page = CoupledPage(result.diagnosis, result.fit.identified);
  page.origin = result.fit.origin;
  return RenderPage(page);
}

std::vector<IdentifiedNumber> NamedNumbers(const DiagnosedTogether& result) {
  std::vector<IdentifiedNumber> numbers;
  for (const NamedEntry& cause : result.diagnosis.causes) {
    numbers.push_back({NameOf(cause.entry),
                       cause.value,
                       cause.std,
                       UnitOf(cause.entry, result.fit.identified.fitted.force_unit)});
  }
  return numbers;
}

}  // namespace

void BindCoupled(py::module_& module) {
  py::class_<CoupledInPython>(
      module, "CoupledIdentification", "One model of several DOFs: docs/coupled.md.")
      .def_property_readonly(
          "is_usable", [](const CoupledInPython& result) { return result.identified.is_usable; })
      .def_property_readonly(
          "message", [](const CoupledInPython& result) { return result.identified.message; })
      .def_property_readonly("model",
                             &UsableCoupledModel,
                             py::return_value_policy::copy,
                             "The CoupledModel. Raises ValueError where the fit is not usable.")
      .def_property_readonly("parameters",
                             [](const CoupledInPython& result) {
                               return DictOf(NumbersOf(UsableCoupledModel(result)));
                             })
      .def_readonly("findings", &CoupledInPython::findings)
      .def_property_readonly(
          "remarks",
          [](const CoupledInPython& result) { return InPythonWords(result.identified.remarks); })
      .def(
          "to_dict",
          [](const CoupledInPython& result) {
            return DictOfJson(FormatCoupledModel(UsableCoupledModel(result)));
          },
          "What fathom_identify --dofs --model writes: schema fathom-model-2.")
      .def("__repr__", &CoupledText)
      .def("_repr_html_", [](const CoupledInPython& result) {
        if (!result.identified.is_usable) return NotebookText(CoupledText(result));
        return NotebookTable(CoupledEntryTable(result.identified.fitted)) +
               NotebookTable(CoupledFigureTable(result.identified.fitted));
      });

  py::class_<DiagnosedTogether>(
      module, "CoupledDiagnosis", "What the diagonal model of several DOFs gets wrong.")
      .def_property_readonly(
          "verdict", [](const DiagnosedTogether& result) { return Name(result.diagnosis.verdict); })
      .def_property_readonly("sentence", &SentenceOf)
      .def_property_readonly(
          "causes",
          [](const DiagnosedTogether& result) { return DictOf(NamedNumbers(result)); },
          "{name: Parameter}: couplings and weak thrusters that the data force.")
      .def_property_readonly(
          "model",
          [](const DiagnosedTogether& result) { return result.fit.identified.fitted; },
          "The accepted CoupledModel.")
      .def_property_readonly(
          "findings", [](const DiagnosedTogether& result) { return result.diagnosis.findings; })
      .def_property_readonly(
          "next_steps",
          [](const DiagnosedTogether& result) { return CoupledNextSteps(result.diagnosis); })
      .def("page", &DiagnosedPage, "The page of fathom_diagnose --dofs --report, HTML.")
      .def(
          "to_dict",
          [](const DiagnosedTogether& result) {
            return DictOfJson(FormatCoupledVerdict(result.diagnosis, result.fit.identified));
          },
          "What fathom_diagnose --dofs --verdict writes: schema fathom-verdict-2.")
      .def("__repr__", &DiagnosedText)
      .def("_repr_html_",
           [](const DiagnosedTogether& result) { return FrameOf(DiagnosedPage(result)); });

  module.def("identify_coupled",
             &IdentifyTogether,
             py::arg("log"),
             py::arg("dofs"),
             py::arg("structure"),
             py::arg("free"),
             py::arg("window"));
  module.def(
      "diagnose_coupled", &DiagnoseTogether, py::arg("log"), py::arg("dofs"), py::arg("window"));
}

}  // namespace fathom
