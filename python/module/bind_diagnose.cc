// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/diagnosis/report/diagnosis_page.h"
#include "fathom/diagnosis/report/diagnosis_tables.h"
#include "fathom/diagnosis/report/legend.h"
#include "fathom/diagnosis/report/next_steps.h"
#include "fathom/diagnosis/report/verdict_file.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/free_decay/log_decay.h"
#include "fathom/joint_refinement/logs/face_on_poses.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/log/remark.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/open_log/open_log.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/dof_of_log.h"
#include "fathom/vehicle/files/thruster_shares.h"

#include "module/arguments.h"
#include "module/arrays.h"
#include "module/bindings.h"
#include "module/logs_argument.h"
#include "module/number.h"
#include "module/python_words.h"
#include "module/tell.h"
#include <fmt/format.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

struct DiagnosedInPython {
  Diagnosis diagnosis;
  std::vector<std::string> fingerprints;
  PageOrigin origin;
};

// A cause as Python sees it: fathom.Cause.
struct NamedCause {
  std::string effect;
  std::vector<IdentifiedNumber> numbers;
  double p_value = 1.0;
  double held_out_gain = 0.0;
  std::vector<std::string> alternatives;
  std::string experiment;
};

Log WithSource(Log log, const std::optional<Source>& source) {
  if (!source) {
    TrackDetectionsIfUsable(&log);
    return log;
  }
  if (*source == Source::kCamera) TrackDetections(&log);
  log = WithSourceOnly(std::move(log), *source);
  if (!(*source == Source::kCamera ? log.pose : log.velocity)) {
    throw InputError(
        fmt::format("source: is {}, and {} has no such source.", Name(*source), log.name));
  }
  return log;
}

void AddRemarksOfLogs(const std::vector<Log>& logs, Diagnosis* diagnosis) {
  for (const Log& log : logs) {
    for (const Remark& remark : log.remarks) {
      if (remark.kind != RemarkKind::kGeneral) diagnosis->remarks.push_back(remark.text);
    }
  }
}

DiagnosedInPython DiagnoseOpened(const std::vector<OpenedLog>& opened,
                                 const std::optional<Dof>& asked,
                                 const std::optional<Source>& source,
                                 DiagnosisOptions options) {
  RequireMotion(opened);
  std::vector<Log> logs = PlainLogs(opened);
  const Dof dof = DofOfAll(logs, asked);
  DiagnosedInPython result;
  result.fingerprints = FingerprintsOf(logs);
  result.origin = OriginInPython(logs);
  if (AreFreeDecays(logs, dof)) {
    throw InputError(
        fmt::format("log: nothing drives it along {}, expected a command: fathom.free_decay() "
                    "tells its damping "
                    "by inertia.",
                    Name(dof)));
  }
  for (Log& log : logs) log = WithSource(std::move(log), source);
  for (Log& log : logs) RefineFaceOnPoses(dof, &log);
  if (const auto vehicle = VehicleOf(logs.front())) options.thrusters = vehicle->thrusters;
  result.diagnosis = Diagnose(logs, dof, options);
  if (const std::string why = WhyOfNoUse(result.diagnosis); !why.empty()) {
    throw InputError("no diagnosis: " + why);
  }
  AddRemarksOfLogs(logs, &result.diagnosis);
  return result;
}

DiagnosedInPython DiagnoseOne(const py::object& log,
                              const std::optional<std::string>& dof,
                              const std::optional<std::string>& source,
                              double false_alarm_rate,
                              double effort,
                              std::uint64_t seed) {
  std::optional<Dof> asked;
  if (dof) asked = ParseArgument("dof", *dof, ParseDof);
  std::optional<Source> asked_source;
  if (source) asked_source = ParseArgument("source", *source, ParseSource);
  DiagnosisOptions options;
  if (!(false_alarm_rate > 0.0 && false_alarm_rate <= 0.5)) {
    throw InputError(fmt::format("false_alarm_rate: is {}, expected above 0 and at most 0.5.",
                                 false_alarm_rate));
  }
  if (!(effort > 0.0)) throw InputError(fmt::format("effort: is {}, expected above 0.", effort));
  options.false_alarm_rate = false_alarm_rate;
  options.effort = effort;
  options.seed = seed;
  const std::vector<OpenedLog> opened = LogsOfArgument(log, asked);
  DiagnosedInPython result = [&] {
    const py::gil_scoped_release release;
    return DiagnoseOpened(opened, asked, asked_source, std::move(options));
  }();
  WarnOf(result.diagnosis.findings);
  return result;
}

std::vector<NamedCause> CausesOf(const DiagnosedInPython& result) {
  const Diagnosis& diagnosis = result.diagnosis;
  const FittedModel model = ModelOf(diagnosis, diagnosis.extended);
  std::vector<NamedCause> causes;
  for (const Cause& cause : diagnosis.causes) {
    const ActiveEffect& active = EffectOfCause(diagnosis, cause);
    causes.push_back({LabelOf(active.effect->info(), active.setting),
                      NumbersOfEffect(model, static_cast<std::size_t>(cause.effect_index)),
                      cause.p_value,
                      cause.held_out_gain,
                      LabelsOf(cause.alternatives),
                      cause.experiment.text});
  }
  return causes;
}

FittedModel ExtendedOf(const DiagnosedInPython& result) {
  FittedModel model = ModelOf(result.diagnosis, result.diagnosis.extended);
  model.log_fingerprints = result.fingerprints;
  return model;
}

std::string VerdictText(const DiagnosedInPython& result) {
  const Diagnosis& diagnosis = result.diagnosis;
  std::string text = fmt::format(
      "{}: {}\n{}\n", Name(diagnosis.dof), Name(diagnosis.verdict), VerdictSentence(diagnosis));
  if (!diagnosis.causes.empty()) text += "\n" + FormatTable(CauseTable(diagnosis));
  text += "\n" + FormatTable(BeforeAndAfterTable(diagnosis)) + NoiseFloorText(diagnosis) + "\n";
  for (const std::string& step : NextSteps(diagnosis)) text += "next: " + step + "\n";
  return text + NoteLines(diagnosis.remarks);
}

std::string VerdictPage(const DiagnosedInPython& result) {
  Page page = DiagnosisPage(result.diagnosis);
  page.origin = result.origin;
  return RenderPage(page);
}

}  // namespace

void BindDiagnose(py::module_& module) {
  py::class_<NamedCause>(module, "Cause", "A cause that the data call for: docs/effects.md.")
      .def_readonly("effect", &NamedCause::effect, "\"thruster_lag\"")
      .def_property_readonly("parameters",
                             [](const NamedCause& cause) { return DictOf(cause.numbers); })
      .def_readonly("p_value", &NamedCause::p_value)
      .def_readonly("held_out_gain",
                    &NamedCause::held_out_gain,
                    "1 - NMAE with / NMAE without it, on data that no fit has seen.")
      .def_readonly("alternatives", &NamedCause::alternatives, "What the logs cannot tell from it.")
      .def_readonly("experiment", &NamedCause::experiment, "What would tell them apart; or empty.")
      .def("__repr__", [](const NamedCause& cause) {
        std::string text = cause.effect;
        for (const IdentifiedNumber& number : cause.numbers) text += "; " + number.Text();
        return text;
      });

  using Result = DiagnosedInPython;
  py::class_<Result>(module, "Diagnosis", "What a model of one DOF gets wrong, and why.")
      .def_property_readonly("dof", [](const Result& result) { return Name(result.diagnosis.dof); })
      .def_property_readonly(
          "verdict",
          [](const Result& result) { return Name(result.diagnosis.verdict); },
          "\"consistent\", \"explained\", \"ambiguous\" or \"unexplained\".")
      .def_property_readonly("sentence",
                             [](const Result& result) { return VerdictSentence(result.diagnosis); })
      .def_property_readonly("causes", &CausesOf)
      .def_property_readonly(
          "model", &ExtendedOf, "The Model with the causes in, which simulate() takes.")
      .def_property_readonly("findings",
                             [](const Result& result) { return result.diagnosis.findings; })
      .def_property_readonly("next_steps",
                             [](const Result& result) { return NextSteps(result.diagnosis); })
      .def_property_readonly(
          "remarks", [](const Result& result) { return InPythonWords(result.diagnosis.remarks); })
      .def("page", &VerdictPage, "The page of fathom_diagnose --report, HTML.")
      .def(
          "to_dict",
          [](const Result& result) {
            return DictOfJson(FormatVerdict(result.diagnosis, result.fingerprints));
          },
          "What fathom_diagnose --verdict writes: schema fathom-verdict-1.")
      .def("__repr__", &VerdictText)
      .def("_repr_html_", [](const Result& result) { return FrameOf(VerdictPage(result)); });

  module.def("diagnose_one",
             &DiagnoseOne,
             py::arg("log"),
             py::arg("dof"),
             py::arg("source"),
             py::arg("false_alarm_rate"),
             py::arg("effort"),
             py::arg("seed"));
}

}  // namespace fathom
