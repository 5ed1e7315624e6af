// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/verdict_file.h"

#include "fathom/base/not_known.h"
#include "fathom/diagnosis/report/candidate_text.h"
#include "fathom/diagnosis/report/cause_text.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/findings/finding_json.h"
#include "fathom/vehicle/files/model_file.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

// What a model file says of a model, and the figures as verdicts name them.
Json FormatDiagnosedModel(const Diagnosis& diagnosis, const DiagnosedModel& model) {
  const Json file = Json::parse(FormatModel(ModelOf(diagnosis, model)));
  Json json = {{"parameters", file.at("parameters")},
               {"mae", model.train.mae},
               {"nmae", model.train.nmae},
               {"n", model.train.num_samples},
               {"duration", model.train.duration},
               {"heldout_mae", model.held_out.mae},
               {"heldout_nmae", model.held_out.nmae},
               {"structure", file.at("structure")},
               {"covariance", file.at("covariance")},
               {"log_likelihood", model.weighed_log_likelihood}};
  for (const char* range : {"speed_range", "force_range"}) {
    if (file.at("fit").contains(range)) json[range] = file.at("fit").at(range);
  }
  return json;
}

// An effect's parameters under their own names.
Json FormatParameters(const Diagnosis& diagnosis,
                      const EffectInfo& info,
                      const std::vector<double>& values,
                      const std::vector<double>& stds) {
  Json parameters = Json::object();
  for (std::size_t k = 0; k < values.size(); ++k) {
    parameters[std::string(info.parameters[k].name)] = {
        {"value", values[k]},
        {"std", k < stds.size() ? stds[k] : kNotKnown},
        {"unit", UnitOf(info.parameters[k].quantity, diagnosis.dof, diagnosis.force_unit)}};
  }
  return parameters;
}

// Which effect, with whom.
Json FormatEffect(const Effect& effect, const EffectSetting& setting) {
  const EffectInfo& info = effect.info();
  Json json = {{"effect", info.name}, {"place", Name(info.place)}};
  if (info.has_partner()) json["partner"] = Name(setting.partner);
  if (setting.reference_force != 1.0) json["reference_force"] = setting.reference_force;
  if (!setting.log.empty()) json["log"] = setting.log;
  return json;
}

Json FormatCause(const Diagnosis& diagnosis, const Cause& cause) {
  const ActiveEffect& active =
      diagnosis.extended.model.effects.at(static_cast<std::size_t>(cause.effect_index));
  const EffectInfo& info = active.effect->info();
  Json json = FormatEffect(*active.effect, active.setting);
  json["parameters"] = FormatParameters(
      diagnosis, info, active.values, EffectStds(diagnosis.extended, cause.effect_index));
  if (cause.thruster) {
    json["thruster"] = {{"name", cause.thruster->name},
                        {"change", cause.thruster->change},
                        {"std", cause.thruster->std}};
  }
  json["p_value"] = cause.p_value;
  json["delta_bic"] = cause.delta_bic;
  json["heldout_gain"] = cause.held_out_gain;
  json["alternatives"] = LabelsOf(cause.alternatives);
  json["experiment"] = cause.experiment.text;
  json["scope"] = info.scope == Scope::kRun ? "run" : "vehicle";
  json["because"] = info.cause;
  json["advice"] = AdviceText(diagnosis, cause);
  return json;
}

Json FormatCandidate(const Diagnosis& diagnosis, const Candidate& candidate) {
  Json json = FormatEffect(*candidate.effect, candidate.setting);
  json["label"] = candidate.label;
  json["parameters"] =
      FormatParameters(diagnosis, candidate.effect->info(), candidate.values, candidate.stds);
  json["score"] = candidate.score;
  json["gain"] = candidate.gain;
  json["delta_bic"] = candidate.delta_bic;
  json["p_value"] = candidate.p_value;
  json["kept"] = candidate.IsKept();
  json["why"] = WhyText(candidate);
  return json;
}

Json FormatLimit(const Diagnosis& diagnosis, const ExclusionLimit& limit) {
  const EffectParameter& parameter = limit.effect->info().parameters.front();
  Json json = FormatEffect(*limit.effect, limit.setting);
  json["label"] = limit.label;
  json["parameter"] = parameter.name;
  json["unit"] = UnitOf(parameter.quantity, diagnosis.dof, diagnosis.force_unit);
  json["is_told"] = limit.is_told;
  json["low"] = limit.is_told ? limit.low : kNotKnown;
  json["high"] = limit.is_told ? limit.high : kNotKnown;
  return json;
}

}  // namespace

FittedModel ModelOf(const Diagnosis& diagnosis, const DiagnosedModel& model) {
  FittedModel fitted;
  fitted.dof = diagnosis.dof;
  fitted.force_unit = diagnosis.force_unit;
  fitted.model = model.model.baseline;
  fitted.effects = model.model.effects;
  Eigen::Index size = kNumParameters;
  for (const ActiveEffect& active : fitted.effects) {
    size += static_cast<Eigen::Index>(active.values.size());
  }
  fitted.covariance = model.covariance;
  if (model.covariance.rows() != size || model.covariance.cols() != size) {
    fitted.covariance.setConstant(size, size, kNotKnown);
  }
  fitted.train = model.train;
  fitted.held_out = model.held_out;
  fitted.range = diagnosis.range;
  return fitted;
}

std::string FormatVerdict(const Diagnosis& diagnosis,
                          const std::vector<std::string>& log_fingerprints) {
  Json causes = Json::array(), candidates = Json::array(), limits = Json::array();
  for (const Cause& cause : diagnosis.causes) causes.push_back(FormatCause(diagnosis, cause));
  for (const Candidate& candidate : diagnosis.candidates) {
    candidates.push_back(FormatCandidate(diagnosis, candidate));
  }
  for (const ExclusionLimit& limit : diagnosis.limits) {
    limits.push_back(FormatLimit(diagnosis, limit));
  }
  const Json json = {{"schema", "fathom-verdict-1"},
                     {"log", fmt::format("{}", fmt::join(diagnosis.logs, ", "))},
                     {"dof", Name(diagnosis.dof)},
                     {"findings", JsonOf<Json>(diagnosis.findings)},
                     {"verdict", Name(diagnosis.verdict)},
                     {"sentence", VerdictSentence(diagnosis)},
                     {"force_unit", diagnosis.force_unit},
                     {"figures_of", FittedQuantity(diagnosis)},
                     {"has_baseline", diagnosis.has_baseline},
                     {"baseline", FormatDiagnosedModel(diagnosis, diagnosis.baseline)},
                     {"causes", causes},
                     {"extended", FormatDiagnosedModel(diagnosis, diagnosis.extended)},
                     {"explained_share", diagnosis.explained_share},
                     {"noise_nmae", diagnosis.noise_nmae},
                     {"coincidence",
                      diagnosis.coincidence ? Json{{"cause", diagnosis.coincidence->label},
                                                   {"input", diagnosis.coincidence->input}}
                                            : Json()},
                     {"remaining_p_value", diagnosis.remaining_p_value},
                     {"heldout_gain",
                      {{"value", diagnosis.held_out_gain},
                       {"low", diagnosis.held_out_gain_low},
                       {"high", diagnosis.held_out_gain_high},
                       {"is_in_poses", diagnosis.gain_is_in_poses},
                       {"by_left_out_blocks", diagnosis.by_left_out_blocks},
                       {"by_left_out_logs", diagnosis.by_left_out_logs}}},
                     {"candidates", candidates},
                     {"limits", limits},
                     {"logs", diagnosis.logs},
                     {"log_fingerprints", log_fingerprints},
                     {"remarks", diagnosis.remarks}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fathom
