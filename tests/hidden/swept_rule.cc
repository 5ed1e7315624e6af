// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "swept_rule.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <glog/logging.h>

namespace fathom::hidden {
namespace {

using Change = std::function<void(double times, DiagnosisOptions*)>;

void Multiply(double times, double* value) { *value *= times; }
void Multiply(double times, int* value) {
  *value = std::max(1, static_cast<int>(std::lround(times * *value)));
}

template <typename T>
Change Of(T VerdictRules::*rule) {
  return
      [rule](double times, DiagnosisOptions* options) { Multiply(times, &(options->rules.*rule)); };
}

template <typename T>
Change Of(T SearchOptions::*rule) {
  return [rule](double times, DiagnosisOptions* options) {
    Multiply(times, &(options->search.*rule));
  };
}

const std::map<std::string, Change>& Changes() {
  static const std::map<std::string, Change> changes = {
      {"material_rest", Of(&VerdictRules::material_rest)},
      {"clear_rest_of_one_input", Of(&VerdictRules::clear_rest_of_one_input)},
      {"material_rest_of_one_input", Of(&VerdictRules::material_rest_of_one_input)},
      {"share_of_work_at_first", Of(&VerdictRules::share_of_work_at_first)},
      {"more_than_scatter", Of(&VerdictRules::more_than_scatter)},
      {"loss_too_much", Of(&VerdictRules::loss_too_much)},
      {"loss_too_much_in_training", Of(&VerdictRules::loss_too_much_in_training)},
      {"trace_in_poses", Of(&VerdictRules::trace_in_poses)},
      {"trace_in_velocities", Of(&VerdictRules::trace_in_velocities)},
      {"material_gain_in_poses", Of(&VerdictRules::material_gain_in_poses)},
      {"least_gain_of_each_log", Of(&VerdictRules::least_gain_of_each_log)},
      {"material_gain", Of(&VerdictRules::material_gain)},
      {"material_gain_without_interval", Of(&VerdictRules::material_gain_without_interval)},
      {"most_work", Of(&SearchOptions::most_work)},
      {"null_draws", Of(&SearchOptions::null_draws)},
      {"beam", Of(&SearchOptions::beam)},
      {"most_refined", Of(&SearchOptions::most_refined)},
      {"most_refined_beside", Of(&SearchOptions::most_refined_beside)},
      {"most_from_momentum", Of(&SearchOptions::most_from_momentum)},
      {"most_starts", Of(&SearchOptions::most_starts)},
      {"hope", Of(&SearchOptions::hope)},
      {"contends", Of(&SearchOptions::contends)},
      {"optimism", Of(&SearchOptions::optimism)},
      {"kept", Of(&SearchOptions::kept)},
      {"least_share", Of(&SearchOptions::least_share)},
      {"least_share_of_several", Of(&SearchOptions::least_share_of_several)},
      {"worth_refining", Of(&SearchOptions::worth_refining)},
      {"worth_refining_beside", Of(&SearchOptions::worth_refining_beside)},
      {"sharpest", Of(&SearchOptions::sharpest)},
      {"caution_of_learned_noise", Of(&SearchOptions::caution_of_learned_noise)},
      {"caution_between_the_grid", Of(&SearchOptions::caution_between_the_grid)},
      {"caution_with_a_partner", Of(&SearchOptions::caution_with_a_partner)},
      {"alike", Of(&SearchOptions::alike)},
      {"open_inertia", Of(&SearchOptions::open_inertia)},
      {"most_pairs", Of(&SearchOptions::most_pairs)},
      {"trials_in_pairs", Of(&SearchOptions::trials_in_pairs)},
      {"least_under_the_baselines_noise", Of(&SearchOptions::least_under_the_baselines_noise)},
      {"beyond_doubt", Of(&SearchOptions::beyond_doubt)},
      {"most_rounds", Of(&SearchOptions::most_rounds)},
      {"rival_share", Of(&SearchOptions::rival_share)},
      {"rival_slack", Of(&SearchOptions::rival_slack)},
      {"most_rivals", Of(&SearchOptions::most_rivals)},
  };
  return changes;
}

}  // namespace

std::vector<std::string> SweptRules() {
  std::vector<std::string> names;
  for (const auto& [name, change] : Changes()) names.push_back(name);
  return names;
}

DiagnosisOptions WithRule(const std::string& name, double times) {
  const auto found = Changes().find(name);
  CHECK(found != Changes().end()) << name;
  DiagnosisOptions options;
  found->second(times, &options);
  return options;
}

}  // namespace fathom::hidden
