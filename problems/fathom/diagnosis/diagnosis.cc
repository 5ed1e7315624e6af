// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/diagnosis.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/diagnosis/description.h"
#include "fathom/diagnosis/fit/identified_model.h"
#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/judge/judgement.h"
#include "fathom/diagnosis/judge/weak_thruster.h"
#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/diagnosis/report/remarks.h"
#include "fathom/diagnosis/report/verdict_file.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/findings/inertia_check.h"
#include "fathom/findings/log_check.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <cmath>
#include <utility>

namespace fathom {
namespace {

// What is told whatever comes of the data.
Diagnosis Begun(const MeasuredSegments& segments, Dof dof) {
  Diagnosis diagnosis;
  diagnosis.dof = dof;
  diagnosis.force_unit = segments.force_unit;
  diagnosis.logs = segments.logs;
  diagnosis.fits_displacement = segments.has_displacement;
  diagnosis.has_velocity = segments.has_velocity;
  return diagnosis;
}

std::vector<Suspect> SuspectsIn(const MeasuredSegments& segments,
                                const Evidence& evidence,
                                const DiagnosisOptions& options,
                                Dof dof) {
  if (evidence.IsNegligible()) return {};
  return options.effects.empty() ? SuspectsFor(segments, dof, EffectCatalogue())
                                 : SuspectsFor(segments, dof, options.effects);
}

// Whether something was named, and the model with it knows its inertia: without a baseline it has
// to stand for itself.
bool IsAModel(const Choice& choice) {
  if (choice.chosen == 0) return false;
  const StructureFit& fit = choice.fit();
  return std::sqrt(fit.covariance(kInertia, kInertia)) < fit.model.baseline.inertia;
}

}  // namespace

Diagnosis Diagnose(std::span<const Log> logs, Dof dof, const DiagnosisOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty())
    throw InputError(problems.front());
  const MeasuredSegments segments = MeasuredSegmentsOf(logs, dof);
  Diagnosis begun = Begun(segments, dof);
  begun.findings = CheckLogs(logs, dof);
  if (options.on_findings) options.on_findings(begun.findings);
  begun.message = WhyNoModel(begun.findings);
  if (!begun.IsUsable()) return begun;
  const Identified identified = IdentifiedModelOf(logs, dof);
  const Preparation preparation = Prepare(segments, dof, identified.model);
  begun.remarks = RemarksOnData(segments, preparation);
  begun.message = preparation.message;
  if (!preparation.prepared) return begun;
  const Prepared& prepared = *preparation.prepared;
  const Evidence evidence = EvidenceOf(prepared.data, prepared.baseline);
  const std::vector<Suspect> suspects = SuspectsIn(segments, evidence, options, dof);
  const Judgement judgement = Judge(prepared, suspects, evidence, options);
  if (!prepared.has_baseline && !IsAModel(judgement.choice)) {
    begun.message = prepared.why_no_baseline;
    return begun;
  }
  if (prepared.has_baseline) AddRemarksOn(identified, &begun.remarks);
  Diagnosis diagnosis = Described(segments, prepared, judgement, std::move(begun));
  for (Cause& cause : diagnosis.causes) {
    const double std = EffectStds(diagnosis.extended, cause.effect_index).front();
    cause.thruster = WeakThrusterOf(EffectOfCause(diagnosis, cause), std, options.thrusters);
  }
  const FittedModel extended = ModelOf(diagnosis, diagnosis.extended);
  if (auto finding = CheckInertia(extended, BodyOf(logs))) {
    diagnosis.findings.push_back(*std::move(finding));
    diagnosis.findings = WarningsFirst(std::move(diagnosis.findings));
  }
  return diagnosis;
}

}  // namespace fathom
