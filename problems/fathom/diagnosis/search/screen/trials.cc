// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/trials.h"

#include "fathom/diagnosis/fit/force_response.h"
#include "fathom/diagnosis/search/screen/signatures.h"
#include "fathom/diagnosis/search/screen/trial_values.h"
#include "fathom/vehicle/effect_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fathom {
namespace {

constexpr double kFineSpacing = 0.2;   // [s], of times about one that looks good
constexpr double kShareOfATone = 0.3;  // of the command's variance, from which on it is one

bool IsShape(const EffectParameter& parameter) { return std::isnan(parameter.null); }

// The trials of one suspect, with a column per amount.
void AppendTrials(const TrainingData& data,
                  int suspect,
                  const EffectInfo& info,
                  const RunScale& scale,
                  Trials* trials) {
  std::vector<int> amounts;
  for (size_t k = 0; k < info.parameters.size(); ++k) {
    if (!IsShape(info.parameters[k])) amounts.push_back(static_cast<int>(k));
  }
  const EffectParameter& amount = info.parameters[amounts.front()];
  for (auto& values : CombinationsOf(info, data, scale)) {
    if (IsAtTheCommandsTone(data, info, values)) continue;
    Trial trial;
    trial.suspect = suspect;
    trial.values = std::move(values);
    trial.amounts = amounts;
    trial.any_sign = amount.search == Search::kAmount && amount.lower < amount.null &&
                     amount.upper > amount.null;
    trial.num_columns = static_cast<int>(amounts.size());
    trials->trials.push_back(std::move(trial));
  }
}

// Numbers the trials' columns and fills them.
void AppendSignatures(const TrainingData& data,
                      const ForceResponse& response,
                      const StructureFit& fit,
                      const std::vector<Suspect>& suspects,
                      Trials* trials) {
  int num_columns = 0;
  for (Trial& trial : trials->trials) {
    trial.first_column = num_columns;
    num_columns += trial.num_columns;
  }
  trials->signatures = SignaturesOf(data, response, fit, suspects, trials->trials);
}

}  // namespace

bool IsAtTheCommandsTone(const TrainingData& data,
                         const EffectInfo& info,
                         const std::vector<double>& values) {
  const Tone& tone = data.command_tone();
  if (!(tone.share > kShareOfATone)) return false;
  const double resolution = 2.0 * std::numbers::pi / data.longest_duration();
  for (size_t k = 0; k < info.parameters.size(); ++k) {
    if (info.parameters[k].search == Search::kFrequencyOfRun &&
        std::abs(values[k] - tone.frequency) < resolution) {
      return true;
    }
  }
  return false;
}

Trials TrialsAbout(const TrainingData& data,
                   const StructureFit& fit,
                   const std::vector<Suspect>& suspects) {
  Trials trials;
  const ForceResponse response(&data, fit);
  if (response.is_empty()) return trials;
  for (size_t k = 0; k < suspects.size(); ++k) {
    const RunScale scale = ScaleOf(data, response, suspects[k]);
    AppendTrials(data, static_cast<int>(k), suspects[k].effect->info(), scale, &trials);
  }
  AppendSignatures(data, response, fit, suspects, &trials);
  return trials;
}

Trials TrialsNear(const TrainingData& data,
                  const StructureFit& fit,
                  const std::vector<Suspect>& suspects,
                  const Trial& trial) {
  Trials trials;
  const auto& parameters = suspects[trial.suspect].effect->info().parameters;
  const auto time = std::find_if(parameters.begin(), parameters.end(), [](const auto& parameter) {
    return parameter.search == Search::kTimeOfRun;
  });
  if (time == parameters.end()) return trials;
  const ForceResponse response(&data, fit);
  if (response.is_empty()) return trials;
  const RunScale scale = ScaleOf(data, response, suspects[trial.suspect]);
  const double middle = trial.values[time - parameters.begin()];
  const double reach = SpacingOfTimes(scale);
  for (double t = std::max(scale.first_time, middle - reach);
       t < std::min(scale.last_time, middle + reach);
       t += kFineSpacing) {
    Trial near = trial;
    near.values[time - parameters.begin()] = t;
    trials.trials.push_back(std::move(near));
  }
  AppendSignatures(data, response, fit, suspects, &trials);
  return trials;
}

}  // namespace fathom
