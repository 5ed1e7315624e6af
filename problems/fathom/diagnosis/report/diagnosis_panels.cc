// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/diagnosis_panels.h"

#include "fathom/base/median.h"
#include "fathom/base/not_known.h"
#include "fathom/diagnosis/report/suspect_signals.h"
#include "fathom/report/format_value.h"
#include "fathom/report/held_curve.h"
#include "fathom/simulate/free_run.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr const char* kBefore = "before";
constexpr const char* kAccounted = "explained by the causes";

// The model with all that is named.
const char* NameOfExtended(const Diagnosis& diagnosis) {
  return diagnosis.ComparesTwoModels() ? "after" : "model";
}

std::string WithSpaces(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string MissingName(const Diagnosis& diagnosis) {
  return IsAngular(diagnosis.dof) ? "missing moment" : "missing force";
}

// Where a curve over `time` must break: stamps much further apart than is usual.
double LongestStep(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (time[i] > time[i - 1]) steps.push_back(time[i] - time[i - 1]);
  }
  if (steps.empty()) return 1.0;
  return std::max(5.0, 20.0 * Median(std::move(steps)));
}

// Of all logs together.
std::string NmaeNote(const Diagnosis& diagnosis, const DiagnosedModel& model) {
  if (std::isfinite(model.held_out.nmae)) {
    const char* const where = diagnosis.by_left_out_logs     ? "left-out"
                              : diagnosis.by_left_out_blocks ? "cross-validated"
                                                             : "held-out";
    return fmt::format("{} NMAE {}", where, ShareText(model.held_out.nmae, 3));
  }
  return std::isfinite(model.train.nmae) ? "NMAE " + ShareText(model.train.nmae, 3) : "";
}

void AddGap(TimePanel* panel) {
  panel->time.push_back(panel->time.back());
  if (panel->measured) panel->measured->values.push_back(kNotKnown);
  for (Series& response : panel->responses) {
    response.values.push_back(kNotKnown);
    if (!response.half_width.empty()) response.half_width.push_back(kNotKnown);
  }
}

// A model's free runs, in every trace.
struct Curve {
  const char* name = "";
  std::string note;  // of all logs together; empty: none
  std::vector<double> ResidualTrace::*run = nullptr;
};

// What is written beside a curve of one of several logs: its own NMAE over what is held out of it,
// or over all of it. The note of all logs together would say nothing of the picture it stands in.
std::string OwnNote(const std::vector<const ResidualTrace*>& traces, const Curve& curve) {
  const bool has_held_out =
      std::ranges::any_of(traces, [](const auto* trace) { return trace->is_held_out; });
  const char* const where = has_held_out ? "held-out " : "";
  std::vector<FreeRun> runs;
  for (const ResidualTrace* trace : traces) {
    if (trace->is_held_out != has_held_out) continue;
    const std::vector<double>& run = trace->*curve.run;
    if (run.size() != trace->time.size()) return fmt::format("{}diverges", where);
    runs.push_back({trace->time, trace->measured, run});
  }
  return fmt::format("{}NMAE {}", where, ShareText(FiguresOfRuns(runs).nmae, 3));
}

bool Diverges(const std::vector<const ResidualTrace*>& traces, const Curve& curve) {
  return std::ranges::any_of(
      traces, [&](const auto* trace) { return (trace->*curve.run).size() != trace->time.size(); });
}

std::string NoteOn(const std::vector<const ResidualTrace*>& traces,
                   const Curve& curve,
                   bool are_several) {
  if (are_several) return OwnNote(traces, curve);
  return curve.note.empty() && Diverges(traces, curve) ? "diverges" : curve.note;
}

std::vector<Curve> CurvesOf(const Diagnosis& diagnosis,
                            const std::string& before_note,
                            const std::string& after_note) {
  const Curve after = {NameOfExtended(diagnosis), after_note, &ResidualTrace::after};
  if (!diagnosis.ComparesTwoModels()) return {after};
  return {{kBefore, before_note, &ResidualTrace::before}, after};
}

// Curves break where nothing was measured for long, as where no marker is in view.
void AddTrace(const ResidualTrace& trace, const std::vector<Curve>& curves, TimePanel* panel) {
  if (!panel->time.empty()) AddGap(panel);
  const double longest_step = LongestStep(trace.time);
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    if (i > 0 && trace.time[i] - trace.time[i - 1] > longest_step) AddGap(panel);
    panel->time.push_back(trace.time[i]);
    panel->measured->values.push_back(trace.measured[i]);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const std::vector<double>& run = trace.*curves[k].run;
      // A run that diverged is left out.
      panel->responses[k].values.push_back(i < run.size() ? run[i] : kNotKnown);
    }
  }
  if (trace.is_held_out) panel->held_out.push_back({trace.time.front(), trace.time.back()});
}

// The traces of a log that hold anything, by time.
std::vector<const ResidualTrace*> TracesOf(const std::string& log,
                                           const std::vector<ResidualTrace>& all) {
  std::vector<const ResidualTrace*> traces;
  for (const ResidualTrace& trace : all) {
    if (trace.log == log && !trace.time.empty()) traces.push_back(&trace);
  }
  std::stable_sort(traces.begin(), traces.end(), [](const auto* a, const auto* b) {
    return a->time.front() < b->time.front();
  });
  return traces;
}

// A panel for each log, with all its traces by time.
std::vector<TimePanel> PanelsOf(const Diagnosis& diagnosis,
                                const std::vector<ResidualTrace>& of,
                                bool are_velocities,
                                const std::vector<Curve>& curves,
                                bool have_notes) {
  std::vector<TimePanel> panels;
  for (const std::string& log : diagnosis.logs) {
    const std::vector<const ResidualTrace*> traces = TracesOf(log, of);
    if (traces.empty()) continue;
    TimePanel panel;
    panel.title = log;
    panel.quantity =
        fmt::format("{} {}", Name(diagnosis.dof), are_velocities ? "velocity" : "displacement");
    panel.unit = are_velocities ? VelocityUnit(diagnosis.dof) : DisplacementUnit(diagnosis.dof);
    panel.measured = Series{"measured", {}, ""};
    for (const Curve& curve : curves) {
      panel.responses.push_back(
          {curve.name, {}, have_notes ? NoteOn(traces, curve, diagnosis.logs.size() > 1) : ""});
    }
    for (const ResidualTrace* trace : traces) AddTrace(*trace, curves, &panel);
    panels.push_back(std::move(panel));
  }
  return panels;
}

}  // namespace

std::vector<TimePanel> FreeRunPanels(const Diagnosis& diagnosis) {
  return PanelsOf(diagnosis,
                  diagnosis.traces,
                  diagnosis.has_velocity,
                  CurvesOf(diagnosis,
                           NmaeNote(diagnosis, diagnosis.baseline),
                           NmaeNote(diagnosis, diagnosis.extended)),
                  true);
}

std::vector<TimePanel> PosePanels(const Diagnosis& diagnosis) {
  return PanelsOf(diagnosis, diagnosis.pose_traces, false, CurvesOf(diagnosis, "", ""), false);
}

std::vector<TimePanel> CommandPanels(const Diagnosis& diagnosis,
                                     const std::vector<ResidualTrace>& traces) {
  std::vector<TimePanel> panels;
  for (const std::string& log : diagnosis.logs) {
    const std::vector<const ResidualTrace*> of_log = TracesOf(log, traces);
    if (of_log.empty()) continue;
    TimePanel panel = HeldCurvePanel(IsAngular(diagnosis.dof) ? "moment" : "force",
                                     ParameterUnit(kBuoyancy, diagnosis.dof, diagnosis.force_unit));
    for (const ResidualTrace* trace : of_log) {
      if (trace->command.time.empty()) continue;
      const TimeInterval shown = {trace->time.front(), trace->time.back()};
      AppendHeldCurve(trace->command.time, trace->command.value, shown, 0.0, &panel);
      if (trace->is_held_out) panel.held_out.push_back(shown);
    }
    panels.push_back(std::move(panel));
  }
  return panels;
}

std::vector<TimePanel> MissingForcePanels(const Diagnosis& diagnosis) {
  const MissingForce& missing = diagnosis.missing_force;
  const double longest_step = LongestStep(missing.time);
  const bool has_explained =
      missing.explained.size() == missing.time.size() && !diagnosis.causes.empty();
  std::vector<TimePanel> panels;
  for (std::size_t i = 0; i < missing.time.size(); ++i) {
    if (i == 0 || missing.time[i] < missing.time[i - 1]) {
      TimePanel& panel = panels.emplace_back();
      panel.quantity = MissingName(diagnosis);
      panel.unit = diagnosis.force_unit;
      panel.responses.push_back({MissingName(diagnosis), {}, ""});
      if (has_explained) panel.responses.push_back({kAccounted, {}, ""});
    }
    TimePanel& panel = panels.back();
    if (!panel.time.empty() && missing.time[i] - panel.time.back() > longest_step) AddGap(&panel);
    panel.time.push_back(missing.time[i]);
    panel.responses[0].values.push_back(missing.mean[i]);
    if (i < missing.std.size()) panel.responses[0].half_width.push_back(2.0 * missing.std[i]);
    if (has_explained) panel.responses[1].values.push_back(missing.explained[i]);
  }
  return panels;
}

std::vector<ScatterPanel> SuspectPanels(const Diagnosis& diagnosis) {
  const MissingForce& missing = diagnosis.missing_force;
  std::vector<ScatterPanel> panels;
  for (const SuspectSignal& signal : SuspectSignalsOf(diagnosis)) {
    ScatterPanel panel = {signal.name,
                          signal.unit,
                          MissingName(diagnosis),
                          diagnosis.force_unit,
                          signal.values,
                          missing.mean,
                          {},
                          kAccounted,
                          ""};
    if (!diagnosis.causes.empty() && missing.explained.size() == signal.values.size()) {
      panel.second_y = missing.explained;
    }
    const double share = ShareExplainedBy(signal, missing.mean);
    if (std::isfinite(share)) panel.note = fmt::format("explains {:.0f} %", 100.0 * share);
    panels.push_back(std::move(panel));
  }
  return panels;
}

std::vector<ParameterPanel> ParameterPanels(const Diagnosis& diagnosis) {
  std::vector<ParameterPanel> panels;
  const auto std_of = [](const DiagnosedModel& model, int i) {
    return i < model.covariance.rows() ? std::sqrt(model.covariance(i, i)) : kNotKnown;
  };
  const auto estimate_of = [&](const char* name, const DiagnosedModel& model, int i) {
    return Estimate{name, ToVector(model.model.baseline)[i], std_of(model, i)};
  };
  for (int i = 0; i < kNumParameters; ++i) {
    ParameterPanel panel;
    panel.name = WithSpaces(kParameterInfo[i].name);
    panel.unit = ParameterUnit(i, diagnosis.dof, diagnosis.force_unit);
    panel.lower_bound = kParameterInfo[i].lower_bound;
    if (diagnosis.ComparesTwoModels()) {
      panel.estimates.push_back(estimate_of(kBefore, diagnosis.baseline, i));
    }
    panel.estimates.push_back(estimate_of(NameOfExtended(diagnosis), diagnosis.extended, i));
    panels.push_back(std::move(panel));
  }
  int index = kNumParameters;
  for (const ActiveEffect& active : diagnosis.extended.model.effects) {
    for (std::size_t k = 0; k < active.values.size(); ++k) {
      const EffectParameter& parameter = active.effect->info().parameters[k];
      const std::string unit = UnitOf(parameter.quantity, diagnosis.dof, diagnosis.force_unit);
      ParameterPanel panel;
      panel.name = fmt::format(
          "{}: {}", LabelOf(active.effect->info(), active.setting), WithSpaces(parameter.name));
      panel.unit = unit == "-" ? "" : unit;
      panel.lower_bound = parameter.lower;
      panel.upper_bound = parameter.upper;
      panel.estimates = {
          {NameOfExtended(diagnosis), active.values[k], std_of(diagnosis.extended, index++)}};
      if (std::isfinite(parameter.null)) {
        panel.reference = parameter.null;
        panel.reference_name = "no effect";
      }
      panels.push_back(std::move(panel));
    }
  }
  return panels;
}

}  // namespace fathom
