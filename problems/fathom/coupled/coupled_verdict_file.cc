// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_verdict_file.h"

#include "fathom/coupled/cause_words.h"
#include "fathom/findings/finding_json.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/files/coupled_model_file.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using VerdictJson = nlohmann::ordered_json;

VerdictJson JsonOfCause(const NamedEntry& cause, const std::string& force_unit) {
  VerdictJson alternatives = VerdictJson::array();
  for (const FreeEntry& entry : cause.not_told_apart) alternatives.push_back(NameOf(entry));
  return {{"entry", NameOf(cause.entry)},
          {"value", cause.value},
          {"std", cause.std},
          {"unit", UnitOf(cause.entry, force_unit)},
          {"alternatives", alternatives},
          {"sentence", CauseSentence(cause, force_unit)}};
}

VerdictJson ByDof(const std::array<double, 6>& values, const std::vector<Dof>& dofs) {
  VerdictJson json = VerdictJson::object();
  for (const Dof dof : dofs) {
    json[std::string(Name(dof))] = values[static_cast<std::size_t>(Index(dof))];
  }
  return json;
}

VerdictJson JsonOfRung(const LadderRung& rung, bool is_standing, const std::vector<Dof>& dofs) {
  const bool is_compared = rung.gain.in_errors != 0.0;
  return {{"structure", rung.name},
          {"numbers", rung.structure.entries.size()},
          {"unseen_nmae", ByDof(rung.unseen_nmae, dofs)},
          {"nearer", is_compared ? VerdictJson(rung.gain.share) : VerdictJson()},
          {"standard_errors", is_compared ? VerdictJson(rung.gain.in_errors) : VerdictJson()},
          {"usable", rung.fit.IsUsable()},
          {"accepted", is_standing}};
}

}  // namespace

std::string FormatCoupledVerdict(const CoupledDiagnosis& diagnosis,
                                 const CoupledIdentification& identified) {
  const FittedCoupledModel& fitted = identified.fitted;
  const std::vector<Dof>& dofs = fitted.model.dofs;
  const Ladder& ladder = *identified.ladder;
  VerdictJson logs = VerdictJson::array(), names = VerdictJson::array();
  for (const CoupledData& data : identified.data) logs.push_back(data.log);
  for (const Dof dof : dofs) names.push_back(Name(dof));
  VerdictJson causes = VerdictJson::array(), rungs = VerdictJson::array();
  for (const NamedEntry& cause : diagnosis.causes) {
    causes.push_back(JsonOfCause(cause, fitted.force_unit));
  }
  for (std::size_t k = 0; k < ladder.rungs.size(); ++k) {
    rungs.push_back(JsonOfRung(ladder.rungs[k], k == ladder.accepted, dofs));
  }
  const VerdictJson json = {{"schema", "fathom-verdict-2"},
                            {"logs", logs},
                            {"dofs", names},
                            {"verdict", Name(diagnosis.verdict)},
                            {"sentence", CoupledVerdictSentence(diagnosis, identified)},
                            {"causes", causes},
                            {"run_nmae", ByDof(diagnosis.run_nmae, dofs)},
                            {"scatter_nmae", ByDof(diagnosis.scatter_nmae, dofs)},
                            {"ladder", rungs},
                            {"findings", JsonOf<VerdictJson>(diagnosis.findings)},
                            {"model", VerdictJson::parse(FormatCoupledModel(fitted))}};
  return json.dump(2, ' ', false, VerdictJson::error_handler_t::replace) + "\n";
}

}  // namespace fathom
