// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/ordinary_file.h"

#include "fathom/base/files/json_text.h"

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson StdsJson(const OrdinaryDives& dives, const OrdinaryKnowledge& knowledge) {
  OrderedJson stds = OrderedJson::object();
  for (std::size_t i = 0; i < dives.parameters.size(); ++i) {
    stds[dives.parameters[i].name] = knowledge.stds[i];
  }
  return {{"weakest", dives.parameters[knowledge.weakest].name},
          {"half_interval", knowledge.share},
          {"std", std::move(stds)}};
}

OrderedJson KnownParametersJson(const OrdinaryDives& dives) {
  OrderedJson parameters = OrderedJson::object();
  for (const OrdinaryParameter& parameter : dives.parameters) {
    parameters[parameter.name] = {{"value", parameter.value},
                                  {"size", parameter.size},
                                  {"std_by_all", parameter.by_all},
                                  {"std_of_fit", parameter.by_fit},
                                  {"unit", parameter.unit}};
  }
  return parameters;
}

OrderedJson StretchesJson(const OrdinaryRequest& request, const OrdinaryDives& dives) {
  OrderedJson list = OrderedJson::array();
  for (const OrdinaryStretch& stretch : dives.stretches) {
    OrderedJson one = {{"log", request.logs[stretch.log_index]},
                       {"from", stretch.time.from},
                       {"to", stretch.time.to},
                       {"alone", StdsJson(dives, stretch.alone)},
                       {"choice", nullptr}};
    if (stretch.place > 0) {
      one["choice"] = stretch.place;
      one["together"] = StdsJson(dives, stretch.together);
    }
    list.push_back(std::move(one));
  }
  return list;
}

OrderedJson RemediesJson(const OrdinaryDives& dives) {
  OrderedJson list = OrderedJson::array();
  for (const Remedy& remedy : dives.remedies) {
    list.push_back(
        {{"kind", Name(remedy.kind)}, {"what", remedy.words}, {"half_interval", remedy.share}});
  }
  return list;
}

}  // namespace

std::string FormatOrdinaryDives(const OrdinaryRequest& request, const OrdinaryDives& dives) {
  const OrderedJson json = {{"schema", "fathom-ordinary-1"},
                            {"model", request.name},
                            {"dof", Name(request.model.dof)},
                            {"logs", request.logs},
                            {"duration", dives.duration},
                            {"fitted_to", dives.is_position ? "displacement" : "velocity"},
                            {"rate", dives.rate},
                            {"noise", dives.noise},
                            {"neighbour_correlation", dives.neighbour_correlation},
                            {"parameters", KnownParametersJson(dives)},
                            {"all", StdsJson(dives, dives.all)},
                            {"stretches", StretchesJson(request, dives)},
                            {"remedies", RemediesJson(dives)}};
  return JsonText(json);
}

}  // namespace fathom
