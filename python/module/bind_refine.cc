// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison_page.h"
#include "fathom/comparison/image_comparison.h"
#include "fathom/comparison/image_comparison_file.h"
#include "fathom/comparison/image_comparison_page.h"
#include "fathom/coupled/coupled_identification.h"
#include "fathom/coupled_refinement/film_refinement.h"
#include "fathom/coupled_refinement/film_text.h"
#include "fathom/findings/log_check.h"
#include "fathom/log/csv/csv_table.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/signal/sources/dof_of_log.h"
#include "fathom/vehicle/files/coupled_model_file.h"

#include "module/arguments.h"
#include "module/arrays.h"
#include "module/bindings.h"
#include "module/coupled_options.h"
#include "module/family_options.h"
#include "module/logs_argument.h"
#include "module/number.h"
#include "module/pose_path.h"
#include "module/python_words.h"
#include "module/tell.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

struct RefinedInPython {
  MarkerLogs markers;
  ImageComparison images;
  PageOrigin origin;

  const Identification& Joint() const { return images.comparison.dofs.front().rows.back(); }
};

struct RefinedTogether {
  MarkerLogs markers;
  FilmRefinement refinement;
  std::vector<Finding> findings;
  std::optional<PathErrors> errors;  // where the true poses are known
};

std::map<std::string, std::string> JointProvenance(const std::vector<OpenedLog>& logs,
                                                   const std::optional<std::string>& initial_guess,
                                                   const JointOptions& joint) {
  return {{"log", PlacesOf(logs)},
          {"family", std::string(Name(Family::kJoint))},
          {"source", std::string(Name(Source::kCamera))},
          {"initial_guess", initial_guess.value_or("")},
          {"clock_offset_std", fmt::format("{}", joint.clock_offset_std)},
          {"size_scale_std", fmt::format("{}", joint.size_scale_std)},
          {"mount_position_std", fmt::format("{}", joint.mount_position_std)},
          {"mount_angle_std", fmt::format("{}", joint.mount_angle_std)},
          {"version", FATHOM_VERSION}};
}

RefinedInPython RefineInPython(const py::object& log,
                               const std::optional<std::string>& dof,
                               const std::optional<std::string>& initial_guess,
                               double clock_offset_std,
                               double size_scale_std,
                               double mount_position_std,
                               double mount_angle_std,
                               const std::optional<std::vector<double>>& gains,
                               const std::string& integrator,
                               double huber,
                               double shooting_window,
                               const std::string& weighting) {
  ImageComparisonOptions options;
  options.identification = OptionsOf({gains, integrator, huber, shooting_window, weighting});
  if (initial_guess) {
    options.initial_guess = ParseArgument("initial_guess", *initial_guess, ParseSignalFamily);
  }
  JointOptions& joint = options.identification.joint;
  joint.clock_offset_std = clock_offset_std;
  joint.size_scale_std = size_scale_std;
  joint.mount_position_std = mount_position_std;
  joint.mount_angle_std = mount_angle_std;
  if (const auto problems = joint.Problems(); !problems.empty()) {
    throw InputError(problems.front() + ".");
  }
  std::optional<Dof> given;
  if (dof) given = ParseArgument("dof", *dof, ParseDof);
  const std::vector<OpenedLog> opened = FilmedLogsOfArgument(log, given);
  RefinedInPython result;
  {
    const py::gil_scoped_release release;
    std::vector<Log> logs = PlainLogs(opened);
    const Dof refined = DofOfAll(logs, given);
    std::vector<std::string> fingerprints = FingerprintsOf(logs);
    result.markers = PrepareMarkerLogs(std::move(logs), refined);
    result.origin = OriginInPython(result.markers.logs);
    result.images = CompareOnImages(result.markers, options);
    Identification& row = result.images.comparison.dofs.front().rows.back();
    row.fitted.provenance = JointProvenance(opened, initial_guess, joint);
    row.fitted.log_fingerprints = std::move(fingerprints);
  }
  WarnOf(result.images.comparison.dofs.front().findings);
  return result;
}

// Warns of red findings before the search, which takes a while.
RefinedTogether RefineTogether(const py::object& log,
                               const std::vector<std::string>& dofs,
                               const std::string& structure,
                               const std::vector<std::string>& free,
                               double window,
                               const std::optional<py::object>& true_poses) {
  FilmRefinementOptions options;
  options.identification = CoupledOptions(dofs, structure, free, window);
  std::optional<Stream> truth;
  if (true_poses) {
    const CsvSpec spec = {{"x", "y", "z", "qx", "qy", "qz", "qw"}, {}, ""};
    truth = ReadCsvTable(PathOf(*true_poses), spec).stream;
  }
  const std::vector<OpenedLog> opened = FilmedLogsOfArgument(log, std::nullopt);
  if (truth && opened.size() > 1) {
    throw InputError("true_poses: holds the poses of one log, expected a single log with it.");
  }
  RefinedTogether result;
  std::vector<std::string> fingerprints;
  {
    const py::gil_scoped_release release;
    std::vector<Log> logs = PlainLogs(opened);
    fingerprints = FingerprintsOf(logs);
    result.markers = PrepareCoupledMarkerLogs(std::move(logs));
    result.findings = CheckLogs(result.markers.logs, options.identification.dofs);
  }
  WarnOf(result.findings);
  const py::gil_scoped_release release;
  FilmRefinement& refinement = result.refinement;
  refinement = RefineCoupled(result.markers, options);
  refinement.fitted.log_fingerprints = std::move(fingerprints);
  refinement.fitted.provenance = {{"log", PlacesOf(opened)},
                                  {"family", std::string(Name(Family::kJoint))},
                                  {"source", std::string(Name(Source::kCamera))},
                                  {"structure", structure},
                                  {"window", fmt::format("{}", window)},
                                  {"version", FATHOM_VERSION}};
  if (!free.empty()) {
    refinement.fitted.provenance["free"] = fmt::to_string(fmt::join(free, ","));
  }
  if (truth && refinement.is_usable) result.errors = PathErrorsOf(refinement, *truth);
  return result;
}

// One for each log; of a log without a refined frame, one of no poses.
std::vector<PosePath> RefinedPaths(const RefinedInPython& result) {
  if (!result.images.joint.IsUsable()) {
    throw InputError("no refined poses: " + result.images.joint.message);
  }
  std::vector<PosePath> paths(result.markers.logs.size());
  for (std::size_t r = 0; r < result.images.joint.segments.size(); ++r) {
    const RefinedSegment& segment = result.images.joint.segments[r];
    PosePath& path = paths[result.markers.log_of_segment[r]];
    for (std::size_t k = 0; k < segment.world_from_body.size(); ++k) {
      path.poses.push_back({.time = result.markers.input.segments[r].time[k],
                            .pose = segment.world_from_body[k],
                            .covariance = segment.pose_covariance[k]});
    }
  }
  return paths;
}

std::vector<PosePath> FilmPaths(const RefinedTogether& result) {
  const FilmRefinement& refinement = result.refinement;
  if (!refinement.is_usable) throw InputError("no refined poses: " + refinement.message);
  std::vector<PosePath> paths(result.markers.logs.size());
  for (std::size_t w = 0; w < refinement.joint.windows.size(); ++w) {
    const RefinedWindow& window = refinement.joint.windows[w];
    const FilmWindow& film = refinement.film.windows[w];
    PosePath& path = paths[result.markers.log_of_segment[film.segment]];
    for (std::size_t k = 0; k < window.world_from_body.size(); ++k) {
      path.poses.push_back({.time = film.time[k],
                            .pose = window.world_from_body[k],
                            .covariance = window.pose_covariance[k]});
    }
  }
  return paths;
}

PosePath OnlyPath(std::vector<PosePath> paths) {
  if (paths.size() == 1) return std::move(paths.front());
  throw InputError(fmt::format(
      "trajectory: {} logs were refined, expected one. trajectories holds one for each.",
      paths.size()));
}

const FittedModel& JointModel(const RefinedInPython& result) {
  if (!result.Joint().is_usable) throw InputError("no usable model: " + result.Joint().message);
  return result.Joint().fitted;
}

const FittedCoupledModel& JointCoupledModel(const RefinedTogether& result) {
  const FilmRefinement& refinement = result.refinement;
  if (!refinement.is_usable) throw InputError("no usable model: " + refinement.message);
  return refinement.fitted;
}

std::string RefinedText(const RefinedInPython& result) {
  const DofComparison& dof = result.images.comparison.dofs.front();
  std::string text = FormatTable(ParameterTable(dof)) + "\n";
  text += FormatTable(IntervalTable(result.images)) + "\n";
  if (result.images.joint.IsUsable()) text += FormatTable(RefinementTable(result.images)) + "\n";
  text += NoteLines(result.images.comparison.remarks);
  for (const std::string& line : CommentsOn(dof)) text += line + "\n";
  return text;
}

std::string FilmText(const RefinedTogether& result) {
  const FilmRefinement& refinement = result.refinement;
  std::string text = refinement.is_usable ? FormatFilmRefinement(refinement)
                                          : "no usable model: " + refinement.message + "\n";
  if (result.errors) text += FormatPathErrors(*result.errors);
  return text + NoteLines(refinement.remarks);
}

std::string RefinedPage(const RefinedInPython& result) {
  Page page = ImageComparisonPage(result.markers, result.images);
  page.origin = result.origin;
  return RenderPage(page);
}

py::object PathErrorDict(const RefinedTogether& result) {
  if (!result.errors) return py::none();
  const auto both = [](const PathError& error) {
    return py::make_tuple(error.position, error.angle);
  };
  py::dict errors;
  errors["pnp"] = both(result.errors->of_pnp);
  errors["refined"] = both(result.errors->refined);
  return errors;
}

constexpr const char* kPathsDoc =
    "A Trajectory of the vehicle (world_from_body) for each log. Raises ValueError where nothing "
    "was refined.";

}  // namespace

void BindRefine(py::module_& module) {
  py::class_<RefinedInPython>(
      module, "Refinement", "Model of one DOF and camera path together, from corners.")
      .def_property_readonly("is_usable",
                             [](const RefinedInPython& result) { return result.Joint().is_usable; })
      .def_property_readonly("message",
                             [](const RefinedInPython& result) { return result.Joint().message; })
      .def_property_readonly("model",
                             &JointModel,
                             py::return_value_policy::copy,
                             "The Model. Raises ValueError where the fit is not usable.")
      .def_property_readonly(
          "parameters",
          [](const RefinedInPython& result) { return DictOf(NumbersOf(JointModel(result))); })
      .def_property_readonly(
          "train", [](const RefinedInPython& result) { return result.Joint().fitted.train; })
      .def_property_readonly(
          "held_out", [](const RefinedInPython& result) { return result.Joint().fitted.held_out; })
      .def_property_readonly("trajectories", &RefinedPaths, kPathsDoc)
      .def_property_readonly(
          "trajectory",
          [](const RefinedInPython& result) { return OnlyPath(RefinedPaths(result)); },
          "That of the only log.")
      .def_property_readonly("findings",
                             [](const RefinedInPython& result) {
                               return result.images.comparison.dofs.front().findings;
                             })
      .def_property_readonly("remarks",
                             [](const RefinedInPython& result) {
                               return InPythonWords(result.images.comparison.remarks);
                             })
      .def("page", &RefinedPage, "The page of fathom_refine --report, HTML.")
      .def(
          "to_dict",
          [](const RefinedInPython& result) {
            return DictOfJson(FormatImageComparison(result.images));
          },
          "What fathom_refine --json writes: schema fathom-comparison-1, a row for each family.")
      .def("__repr__", &RefinedText)
      .def("_repr_html_",
           [](const RefinedInPython& result) { return FrameOf(RefinedPage(result)); });

  py::class_<RefinedTogether>(
      module, "CoupledRefinement", "Model of several DOFs and camera path together, from corners.")
      .def_property_readonly(
          "is_usable", [](const RefinedTogether& result) { return result.refinement.is_usable; })
      .def_property_readonly(
          "message", [](const RefinedTogether& result) { return result.refinement.message; })
      .def_property_readonly("model",
                             &JointCoupledModel,
                             py::return_value_policy::copy,
                             "The CoupledModel. Raises ValueError where the fit is not usable.")
      .def_property_readonly("parameters",
                             [](const RefinedTogether& result) {
                               return DictOf(NumbersOf(JointCoupledModel(result)));
                             })
      .def_property_readonly("trajectories", &FilmPaths, kPathsDoc)
      .def_property_readonly(
          "trajectory",
          [](const RefinedTogether& result) { return OnlyPath(FilmPaths(result)); },
          "That of the only log.")
      .def_property_readonly("path_errors",
                             &PathErrorDict,
                             "With true_poses {\"pnp\": ([m], [rad]), \"refined\": ([m], [rad])}: "
                             "root mean squares. None without.")
      .def_readonly("findings", &RefinedTogether::findings)
      .def_property_readonly(
          "remarks",
          [](const RefinedTogether& result) { return InPythonWords(result.refinement.remarks); })
      .def(
          "to_dict",
          [](const RefinedTogether& result) {
            return DictOfJson(FormatCoupledModel(JointCoupledModel(result)));
          },
          "What fathom_refine --dofs --model writes: schema fathom-model-2.")
      .def("__repr__", &FilmText)
      .def("_repr_html_",
           [](const RefinedTogether& result) { return NotebookText(FilmText(result)); });

  module.def("refine_one",
             &RefineInPython,
             py::arg("log"),
             py::arg("dof"),
             py::arg("initial_guess"),
             py::arg("clock_offset_std"),
             py::arg("size_scale_std"),
             py::arg("mount_position_std"),
             py::arg("mount_angle_std"),
             py::arg("gains"),
             py::arg("integrator"),
             py::arg("huber"),
             py::arg("shooting_window"),
             py::arg("weighting"));
  module.def("refine_coupled",
             &RefineTogether,
             py::arg("log"),
             py::arg("dofs"),
             py::arg("structure"),
             py::arg("free"),
             py::arg("window"),
             py::arg("true_poses"));
}

}  // namespace fathom
