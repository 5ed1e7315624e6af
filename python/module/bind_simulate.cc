// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/log_check.h"
#include "fathom/tool/coupled_scores.h"
#include "fathom/tool/log_scores.h"

#include <cmath>
#include <limits>

#include "module/arguments.h"
#include "module/arrays.h"
#include "module/bindings.h"
#include "module/logs_argument.h"
#include "module/python_words.h"
#include "module/tell.h"
#include <fmt/format.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

// What a model of one DOF predicts for a log.
struct PredictedInPython {
  LogScore score;
  FittedModel model;
  std::string text;
};

// The same of a model of several.
struct PredictedTogether {
  CoupledScore score;
  double horizon = std::numeric_limits<double>::infinity();
  std::vector<Finding> findings;
};

OpenedLog OneLogFor(const py::object& log, std::optional<Dof> dof) {
  std::vector<OpenedLog> logs = LogsOfArgument(log, dof);
  if (logs.size() > 1) throw InputError("log: names several, expected one.");
  return std::move(logs.front());
}

std::string PredictedText(const LogScore& score, const Log& log, const FittedModel& model) {
  if (!score.prediction) {
    return fmt::format(
        "The simulation diverges or is too stiff: inertia {:g}, linear damping {:g}.\n",
        model.model.inertia,
        model.model.linear_damping);
  }
  return LogScoreText(score, log, model) + NoteLines(score.remarks) +
         NoteLines(RemarksOfFile(model));
}

PredictedInPython SimulateOne(const FittedModel& model,
                              const py::object& log,
                              bool keep_run_effects) {
  const OpenedLog opened = OneLogFor(log, model.dof);
  PredictedInPython result = [&] {
    const py::gil_scoped_release release;
    PredictedInPython predicted = {ScoreLog(model, opened.log, keep_run_effects), model, ""};
    predicted.text = PredictedText(predicted.score, opened.log, model);
    return predicted;
  }();
  WarnOf(result.score.findings);
  return result;
}

PredictedTogether SimulateTogether(const FittedCoupledModel& model,
                                   const py::object& log,
                                   double horizon) {
  if (!(horizon > 0.0)) {
    throw InputError(fmt::format("horizon: is {}, expected more than 0 s.", horizon));
  }
  const OpenedLog opened = OneLogFor(log, std::nullopt);
  PredictedTogether result = [&] {
    const py::gil_scoped_release release;
    RequireMotion({opened});
    return PredictedTogether{ScoreCoupled(model, opened.log, horizon),
                             horizon,
                             CheckLogs({&opened.log, 1}, model.model.dofs)};
  }();
  WarnOf(result.findings);
  return result;
}

// One array over all segments; empty where the simulation diverges. `get(k)`: of segment k.
template <typename Get>
py::array_t<double> Joined(const PredictedInPython& result, Get get) {
  std::vector<double> all;
  if (!result.score.prediction) return ArrayOf(all);
  const LogPrediction& prediction = *result.score.prediction;
  for (std::size_t k = 0; k < prediction.segments.size(); ++k) {
    const std::vector<double>& part = get(prediction, k);
    all.insert(all.end(), part.begin(), part.end());
  }
  return ArrayOf(all);
}

py::array_t<bool> IsOf(const PredictedInPython& result, LogPart part) {
  std::vector<bool> is_of;
  if (!result.score.prediction) return ArrayOf(is_of);
  const LogPrediction& prediction = *result.score.prediction;
  for (std::size_t k = 0; k < prediction.segments.size(); ++k) {
    is_of.insert(is_of.end(), prediction.segments[k].time.size(), prediction.parts[k] == part);
  }
  return ArrayOf(is_of);
}

FitFigures FiguresOf(const PredictedInPython& result, FitFigures LogPrediction::*figures) {
  return result.score.prediction ? *result.score.prediction.*figures : FitFigures();
}

py::array_t<double> TimeTogether(const PredictedTogether& result) {
  std::vector<double> time;
  if (!result.score.prediction) return ArrayOf(time);
  for (const CoupledSegment& segment : result.score.data.segments) {
    time.insert(time.end(), segment.time.begin(), segment.time.end());
  }
  return ArrayOf(time);
}

// By DOF, one array over all segments. `velocity(s)`: of segment s, a six-vector for each stamp.
template <typename Velocity>
py::dict VelocityByDof(const PredictedTogether& result, Velocity velocity) {
  py::dict by_dof;
  for (const Dof dof : result.score.data.dofs) {
    std::vector<double> all;
    for (std::size_t s = 0; result.score.prediction && s < result.score.data.segments.size(); ++s) {
      for (const Vector6& nu : velocity(s)) all.push_back(nu[Index(dof)]);
    }
    by_dof[py::str(std::string(Name(dof)))] = ArrayOf(all);
  }
  return by_dof;
}

py::dict FiguresTogether(const PredictedTogether& result,
                         std::array<FitFigures, 6> CoupledPrediction::*figures) {
  py::dict by_dof;
  for (const Dof dof : result.score.data.dofs) {
    by_dof[py::str(std::string(Name(dof)))] =
        result.score.prediction
            ? (*result.score.prediction.*figures)[static_cast<std::size_t>(Index(dof))]
            : FitFigures();
  }
  return by_dof;
}

std::string TextTogether(const PredictedTogether& result) {
  if (!result.score.prediction) return "The simulation diverges. A horizon begins it anew.\n";
  return CoupledScoreText(result.score, result.horizon) + NoteLines(result.score.data.remarks);
}

void BindPrediction(py::module_& module) {
  using Result = PredictedInPython;
  py::class_<Result>(
      module,
      "Prediction",
      "A free run of a model over a log's command, at the stamps of its motion stream.")
      .def_property_readonly(
          "is_usable",
          [](const Result& result) { return result.score.prediction.has_value(); },
          "False: the simulation diverges, and the arrays are empty.")
      .def_property_readonly("dof", [](const Result& result) { return Name(result.model.dof); })
      .def_property_readonly(
          "time",
          [](const Result& result) {
            return Joined(
                result, [](const LogPrediction& of, std::size_t k) { return of.segments[k].time; });
          },
          "[s], shape (n,)")
      .def_property_readonly(
          "velocity",
          [](const Result& result) {
            return Joined(result,
                          [](const LogPrediction& of, std::size_t k) { return of.velocity[k]; });
          },
          "Predicted [m/s] or [rad/s], shape (n,)")
      .def_property_readonly(
          "measured",
          [](const Result& result) {
            return Joined(result, [](const LogPrediction& of, std::size_t k) {
              return of.segments[k].velocity;
            });
          },
          "[m/s] or [rad/s], shape (n,); NaN where the log does not measure it")
      .def_property_readonly(
          "is_train",
          [](const Result& result) { return IsOf(result, LogPart::kTrain); },
          "bool, shape (n,): samples that a fit of this log takes")
      .def_property_readonly(
          "is_held_out",
          [](const Result& result) { return IsOf(result, LogPart::kHeldOut); },
          "bool, shape (n,)")
      .def_property_readonly(
          "figures",
          [](const Result& result) { return FiguresOf(result, &LogPrediction::figures); },
          "Of training and held-out data together.")
      .def_property_readonly(
          "train", [](const Result& result) { return FiguresOf(result, &LogPrediction::train); })
      .def_property_readonly(
          "held_out",
          [](const Result& result) { return FiguresOf(result, &LogPrediction::held_out); })
      .def_property_readonly(
          "is_trained_on_it",
          [](const Result& result) { return result.score.is_trained_on_it; },
          "Whether the model was identified from this log.")
      .def_property_readonly("findings", [](const Result& result) { return result.score.findings; })
      .def_property_readonly(
          "remarks", [](const Result& result) { return InPythonWords(result.score.remarks); })
      .def(
          "to_dict",
          [](const Result& result) {
            return DictOfJson(LogScoresJson({&result.score, 1}, result.model));
          },
          "What fathom_simulate --json writes: schema fathom-score-1.")
      .def("__repr__", [](const Result& result) { return result.text; });
}

void BindPredictionTogether(py::module_& module) {
  using Result = PredictedTogether;
  py::class_<Result>(module,
                     "CoupledPrediction",
                     "Free runs of a model of several DOFs, at the stamps of the log's velocities.")
      .def_property_readonly(
          "is_usable", [](const Result& result) { return result.score.prediction.has_value(); })
      .def_property_readonly("time", &TimeTogether, "[s], shape (n,)")
      .def_property_readonly(
          "velocity",
          [](const Result& result) {
            return VelocityByDof(result, [&](std::size_t s) -> const std::vector<Vector6>& {
              return result.score.prediction->velocity.front()[s];
            });
          },
          "{dof: predicted [m/s] or [rad/s], shape (n,)}")
      .def_property_readonly(
          "measured",
          [](const Result& result) {
            return VelocityByDof(result, [&](std::size_t s) -> const std::vector<Vector6>& {
              return result.score.data.segments[s].velocity;
            });
          },
          "{dof: [m/s] or [rad/s], shape (n,)}; NaN where the log does not measure it")
      .def_property_readonly(
          "figures",
          [](const Result& result) { return FiguresTogether(result, &CoupledPrediction::figures); },
          "{dof: Figures}")
      .def_property_readonly(
          "train",
          [](const Result& result) { return FiguresTogether(result, &CoupledPrediction::train); })
      .def_property_readonly("held_out",
                             [](const Result& result) {
                               return FiguresTogether(result, &CoupledPrediction::held_out);
                             })
      .def_property_readonly(
          "position_error_10_s",
          [](const Result& result) {
            return result.score.prediction ? result.score.prediction->position_error
                                           : std::numeric_limits<double>::quiet_NaN();
          },
          "10 s after a start [m], RMS; NaN without positions.")
      .def_readonly("findings", &Result::findings)
      .def_property_readonly(
          "remarks", [](const Result& result) { return InPythonWords(result.score.data.remarks); })
      .def(
          "to_dict",
          [](const Result& result) {
            return DictOfJson(CoupledScoresJson({&result.score, 1}, result.horizon));
          },
          "What fathom_simulate --json writes: schema fathom-coupled-score-1.")
      .def("__repr__", &TextTogether);
}

}  // namespace

void BindSimulate(py::module_& module) {
  BindPrediction(module);
  BindPredictionTogether(module);
  module.def(
      "simulate_one", &SimulateOne, py::arg("model"), py::arg("log"), py::arg("keep_run_effects"));
  module.def(
      "simulate_coupled", &SimulateTogether, py::arg("model"), py::arg("log"), py::arg("horizon"));
}

}  // namespace fathom
