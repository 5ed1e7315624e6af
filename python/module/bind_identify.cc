// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/log_decay.h"
#include "fathom/identification/identification_text.h"
#include "fathom/identification/log_identification.h"
#include "fathom/identification/run_agreement_text.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/signal/sources/dof_of_log.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "module/arguments.h"
#include "module/arrays.h"
#include "module/bindings.h"
#include "module/family_options.h"
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

// A result with the file that its velocities are said to come from.
struct IdentifiedInPython {
  LogIdentification identified;
  std::string velocity_files;
};

// As fathom_identify writes them.
std::map<std::string, std::string> Provenance(const std::vector<OpenedLog>& logs,
                                              const LogIdentificationOptions& options,
                                              const FamilyArguments& arguments,
                                              const Identification& result) {
  const AdaptiveOptions& adaptive = options.identification.adaptive;
  std::string gains;
  if (adaptive.gains) gains = FormatGains(*adaptive.gains);
  if (result.gains) gains = FormatGains(*result.gains);
  std::map<std::string, std::string> provenance = {
      {"log", PlacesOf(logs)},
      {"family", std::string(Name(result.family))},
      {"source", std::string(Name(result.source))},
      {"velocity", logs.front().velocity},
      {"held_out", logs.front().held_out},
      {"gains", gains},
      {"integrator", arguments.integrator},
      {"offset", std::string(Name(options.offset))},
      {"huber", fmt::format("{}", arguments.huber)},
      {"shooting_window", fmt::format("{}", arguments.shooting_window)},
      {"version", FATHOM_VERSION}};
  if (!result.weighting.empty()) {
    provenance["weighting"] = result.weighting;
    provenance["weighting_reason"] = result.weighting_reason;
  }
  return provenance;
}

std::string VelocityFilesOf(const std::vector<OpenedLog>& logs) {
  namespace fs = std::filesystem;
  std::set<std::string> files;
  for (const OpenedLog& log : logs) {
    if (!log.velocity.empty()) {
      files.insert(fs::path(log.velocity).filename().string());
    } else if (fs::is_regular_file(log.place)) {
      files.insert(fs::path(log.place).filename().string());
    } else {
      files.insert("velocity.csv");
    }
  }
  return fmt::format("{}", fmt::join(files, ", "));
}

// Throws InputError where nothing drives the logs.
void RequireDriven(const std::vector<Log>& logs, Dof dof) {
  if (!AreFreeDecays(logs, dof)) return;
  throw InputError(fmt::format(
      "log: nothing drives it along {}, expected a command: fathom.free_decay() tells its damping "
      "by inertia.",
      Name(dof)));
}

IdentifiedInPython Fit(const std::vector<OpenedLog>& opened,
                       const LogIdentificationOptions& options,
                       const FamilyArguments& arguments) {
  RequireMotion(opened);
  std::vector<Log> logs = PlainLogs(opened);
  RequireDriven(logs, DofOfAll(logs, options.dof));
  if (options.source == Source::kCamera || options.family == Family::kJoint) {
    for (Log& log : logs) TrackDetections(&log);
  }
  std::vector<std::string> fingerprints = FingerprintsOf(logs);
  IdentifiedInPython result = {IdentifyFromLogs(std::move(logs), options), VelocityFilesOf(opened)};
  result.identified.signals.train.clear();
  result.identified.signals.held_out.clear();
  Identification& fit = result.identified.result;
  fit.fitted.provenance = Provenance(opened, options, arguments, fit);
  fit.fitted.log_fingerprints = std::move(fingerprints);
  return result;
}

IdentifiedInPython IdentifyInPython(const py::object& log,
                                    const std::optional<std::string>& dof,
                                    const std::string& family,
                                    const std::optional<std::string>& source,
                                    const std::string& offset,
                                    const std::optional<std::vector<double>>& gains,
                                    const std::string& integrator,
                                    double huber,
                                    double shooting_window,
                                    const std::string& weighting) {
  const FamilyArguments arguments = {gains, integrator, huber, shooting_window, weighting};
  LogIdentificationOptions options;
  options.family = ParseArgument("family", family, ParseFamily);
  options.identification = OptionsOf(arguments);
  options.offset = ParseArgument("offset", offset, ParseOffsetScope);
  if (dof) options.dof = ParseArgument("dof", *dof, ParseDof);
  if (source) options.source = ParseArgument("source", *source, ParseSource);
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(problems.front() + ".");
  }
  const std::vector<OpenedLog> logs = LogsOfArgument(log, options.dof);
  IdentifiedInPython result = [&] {
    const py::gil_scoped_release release;
    return Fit(logs, options, arguments);
  }();
  WarnOf(result.identified.findings);
  return result;
}

std::string Text(const IdentifiedInPython& result) {
  const LogIdentification& identified = result.identified;
  const FittedModel& fitted = identified.result.fitted;
  std::string text = FormatIdentification(identified.result, result.velocity_files);
  if (!identified.offsets.empty()) {
    text += "\n" + FormatTable(OffsetTable(identified.offsets, fitted.dof, fitted.force_unit));
  }
  if (identified.agreement) {
    text += "\n" + FormatTable(RunTable(*identified.agreement, fitted.dof, fitted.force_unit));
  }
  return text + NoteLines(identified.signals.remarks) + NoteLines(identified.remarks);
}

std::string Html(const IdentifiedInPython& result) {
  const LogIdentification& identified = result.identified;
  if (!identified.result.is_usable) return NotebookText(Text(result));
  std::string html = NotebookTable(IdentificationTable(identified.result));
  const FittedModel& fitted = identified.result.fitted;
  if (identified.agreement) {
    html += NotebookTable(RunTable(*identified.agreement, fitted.dof, fitted.force_unit));
  }
  return html + NotebookText(NoteLines(fitted.caveats));
}

const FittedModel& UsableModel(const IdentifiedInPython& result) {
  const Identification& fit = result.identified.result;
  if (!fit.is_usable) throw InputError("no usable model: " + fit.message);
  return fit.fitted;
}

}  // namespace

void BindIdentify(py::module_& module) {
  using Result = IdentifiedInPython;
  py::class_<Result>(module, "Identification", "One family's model of one DOF.")
      .def_property_readonly(
          "is_usable", [](const Result& result) { return result.identified.result.is_usable; })
      .def_property_readonly(
          "message",
          [](const Result& result) { return result.identified.result.message; },
          "Why the fit ended as it did.")
      .def_property_readonly(
          "family", [](const Result& result) { return Name(result.identified.result.family); })
      .def_property_readonly(
          "source", [](const Result& result) { return Name(result.identified.result.source); })
      .def_property_readonly("model",
                             &UsableModel,
                             py::return_value_policy::copy,
                             "The Model. Raises ValueError where the fit is not usable.")
      .def_property_readonly(
          "parameters",
          [](const Result& result) { return DictOf(NumbersOf(UsableModel(result))); },
          "{name: Parameter}, those of the model.")
      .def_property_readonly(
          "train", [](const Result& result) { return result.identified.result.fitted.train; })
      .def_property_readonly(
          "held_out", [](const Result& result) { return result.identified.result.fitted.held_out; })
      .def_property_readonly("findings",
                             [](const Result& result) { return result.identified.findings; })
      .def_property_readonly(
          "remarks",
          [](const Result& result) {
            std::vector<std::string> remarks = result.identified.signals.remarks;
            std::ranges::copy(result.identified.remarks, std::back_inserter(remarks));
            return InPythonWords(remarks);
          },
          "On the data, a sentence each.")
      .def(
          "to_dict",
          [](const Result& result) { return DictOfJson(FormatModel(UsableModel(result))); },
          "What fathom_identify --model writes: schema fathom-model-1, docs/file_formats.md.")
      .def("__repr__", &Text)
      .def("_repr_html_", &Html);

  module.def("identify_one",
             &IdentifyInPython,
             py::arg("log"),
             py::arg("dof"),
             py::arg("family"),
             py::arg("source"),
             py::arg("offset"),
             py::arg("gains"),
             py::arg("integrator"),
             py::arg("huber"),
             py::arg("shooting_window"),
             py::arg("weighting"));
}

}  // namespace fathom
