// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/diagnosis.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/data/records.h"
#include "fathom/diagnosis/description.h"
#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/judge/judgement.h"
#include "fathom/diagnosis/report/remarks.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/diagnosis/search/thinned_search.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <utility>

namespace fathom {
namespace {

// What is told whatever comes of the data.
Diagnosis Begun(const Records& records, const Preparation& preparation, Dof dof) {
  Diagnosis diagnosis;
  diagnosis.dof = dof;
  diagnosis.force_unit = records.force_unit;
  diagnosis.logs = records.logs;
  diagnosis.fits_displacement = records.has_displacement;
  diagnosis.has_velocity = records.has_velocity;
  diagnosis.remarks = RemarksOnData(records, preparation.num_outliers);
  diagnosis.message = preparation.message;
  return diagnosis;
}

std::vector<Suspect> SuspectsIn(const Records& records,
                                const Evidence& evidence,
                                const DiagnosisOptions& options,
                                Dof dof) {
  if (evidence.IsNegligible()) return {};
  return options.effects.empty() ? SuspectsFor(records, dof, EffectCatalogue())
                                 : SuspectsFor(records, dof, options.effects);
}

}  // namespace

Diagnosis Diagnose(std::span<const Log> logs, Dof dof, const DiagnosisOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty())
    throw InputError(problems.front());
  const Records records = RecordsOf(logs, dof);
  const Preparation preparation = Prepare(records, dof);
  Diagnosis begun = Begun(records, preparation, dof);
  if (!preparation.prepared) return begun;
  const Prepared& prepared = *preparation.prepared;
  const Evidence evidence = EvidenceOf(prepared.data, prepared.baseline);
  const std::vector<Suspect> suspects = SuspectsIn(records, evidence, options, dof);
  const SearchResult search = SearchThinned(prepared, suspects, options);
  const Judgement judgement = Judge(prepared, suspects, search, evidence, options);
  return Described(records, prepared, suspects, search, judgement, options.seed, std::move(begun));
}

}  // namespace fathom
