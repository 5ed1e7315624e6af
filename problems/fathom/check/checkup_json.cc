// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/checkup_json.h"

#include "fathom/base/files/json_text.h"
#include "fathom/check/checkup_text.h"
#include "fathom/check/checkup_verdict.h"
#include "fathom/check/known_parameters.h"
#include "fathom/findings/finding_json.h"
#include "fathom/vehicle/parameters.h"

#include <cstddef>
#include <utility>

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

Json JsonOf(const TimeInterval& interval) { return Json::array({interval.from, interval.to}); }

}  // namespace

std::string FormatCheckupJson(const LogCheckup& checkup) {
  Json streams = Json::array(), dofs = Json::array(), remarks = Json::array();
  for (const Remark& remark : checkup.log.remarks) remarks.push_back(remark.text);
  for (const StreamSummary& stream : checkup.streams) {
    streams.push_back({{"file", stream.file},
                       {"rows", stream.rows},
                       {"first", stream.first},
                       {"last", stream.last},
                       {"rate", stream.rate},
                       {"longest_gap", stream.longest_gap}});
  }
  for (const DofCheckup& dof : checkup.dofs) {
    Json parameters = Json::array(), stretches = Json::array();
    if (dof.model && dof.model->is_usable) {
      const FittedModel& fitted = dof.model->fitted;
      const ParameterVector values = ToVector(fitted.model);
      for (int i = 0; i < kNumParameters; ++i) {
        parameters.push_back({{"name", kParameterInfo[static_cast<std::size_t>(i)].name},
                              {"unit", ParameterUnit(i, fitted.dof, fitted.force_unit)},
                              {"value", values[i]},
                              {"std", StdOf(fitted, i)},
                              {"known", HowWellKnown(checkup, dof, i)}});
      }
    }
    for (const TimeInterval& stretch : dof.excitation.stretches) {
      stretches.push_back(JsonOf(stretch));
    }
    dofs.push_back(
        {{"dof", Name(dof.dof)},
         {"why_not", dof.why_not},
         {"findings", JsonOf<Json>(dof.findings)},
         {"parameters", std::move(parameters)},
         {"caveats", CaveatsOn(dof)},
         {"excited", std::move(stretches)},
         {"held_out", dof.excitation.held_out ? JsonOf(*dof.excitation.held_out) : Json(nullptr)}});
  }
  const Json json = {{"schema", "fathom-check-1"},
                     {"log", checkup.log.name},
                     {"verdict", Verdict(checkup)},
                     {"streams", std::move(streams)},
                     {"findings", JsonOf<Json>(checkup.findings)},
                     {"dofs", std::move(dofs)},
                     {"remarks", std::move(remarks)}};
  return JsonText(json);
}

}  // namespace fathom
