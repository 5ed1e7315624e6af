// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_diagnosis.h"

#include "fathom/simulate/noise_floor.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace fathom {
namespace {

constexpr double kLeastMissed = 0.01;  // of the motion: of less nobody asks the cause

bool IsOffDiagonal(const FreeEntry& entry) {
  using Kind = FreeEntry::Kind;
  return entry.row != entry.column &&
         (entry.kind == Kind::kInertia || entry.kind == Kind::kLinearDamping);
}

// What the search named, as the accepted model has it, and of a structure that was accepted as a
// whole the numbers that stand clear of 0.
std::vector<NamedEntry> CausesIn(const CoupledSummary& fit, const Ladder& ladder) {
  std::vector<NamedEntry> causes;
  for (const FreeEntry& entry : fit.entries) {
    const double value = ValueIn(fit.model, entry), std = StdOf(fit, entry);
    const auto named = std::ranges::find(ladder.named, entry, &NamedEntry::entry);
    if (named != ladder.named.end()) {
      causes.push_back({entry, value, std, named->not_told_apart, named->without});
    } else if (IsOffDiagonal(entry) && StrengthOf(fit, entry, {}) > kStillThere) {
      causes.push_back({entry, value, std, {}, 0.0});
    }
  }
  return causes;
}

bool IsRed(const Finding& finding) { return finding.severity == Severity::kWarning; }

Verdict VerdictOf(const CoupledDiagnosis& diagnosis) {
  if (diagnosis.causes.empty()) {
    const bool is_open =
        !diagnosis.missed.empty() || std::ranges::any_of(diagnosis.findings, IsRed);
    return is_open ? Verdict::kUnexplained : Verdict::kConsistent;
  }
  const bool is_ambiguous = std::ranges::any_of(
      diagnosis.causes, [](const NamedEntry& cause) { return !cause.not_told_apart.empty(); });
  return is_ambiguous ? Verdict::kAmbiguous : Verdict::kExplained;
}

}  // namespace

CoupledDiagnosis DiagnoseCoupled(const CoupledIdentification& identified,
                                 std::vector<Finding> findings) {
  CoupledDiagnosis diagnosis;
  diagnosis.findings = std::move(findings);
  diagnosis.causes = CausesIn(identified.fit, *identified.ladder);
  diagnosis.run_nmae.fill(std::numeric_limits<double>::quiet_NaN());
  diagnosis.scatter_nmae = diagnosis.run_nmae;
  for (const Dof dof : identified.fitted.model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    const std::vector<FreeRun> runs = FreeRunsAlong(dof, identified.data, identified.prediction);
    diagnosis.scatter_nmae[at] = NmaeOfScatter(runs);
    diagnosis.run_nmae[at] = FiguresOfRuns(runs).nmae;
    if (diagnosis.run_nmae[at] >
        std::max(kMuchMoreThanScatter * diagnosis.scatter_nmae[at], kLeastMissed)) {
      diagnosis.missed.push_back(dof);
    }
  }
  diagnosis.verdict = VerdictOf(diagnosis);
  return diagnosis;
}

}  // namespace fathom
