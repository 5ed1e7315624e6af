// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "log_plan.h"

#include "fathom/synthesize/effects/unlisted_effects.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>

#include "drawn_setup.h"

namespace fathom::hidden {
namespace {

// Two mechanisms of which one log can hold both: not two that want different company.
bool CanStandTogether(const EffectInfo& a, const EffectInfo& b) {
  const auto turns = [](const EffectInfo& info) {
    return info.name == "lever_arm" || info.name == "coriolis_coupling";
  };
  // Those of roll alone stand with those of any DOF that need no other one.
  const auto tilts = [](const EffectInfo& info) { return info.acts_along != nullptr; };
  return a.name != b.name && !(a.has_partner() && b.has_partner()) && !(turns(a) && b.needs_pose) &&
         !(turns(b) && a.needs_pose) && !(tilts(a) && b.has_partner()) &&
         !(tilts(b) && a.has_partner());
}

}  // namespace

std::vector<LogPlan> DrawPlans(const PlanSizes& sizes, std::uint64_t seed) {
  std::vector<LogPlan> plans;
  for (int i = 0; i < sizes.nothing; ++i) plans.push_back({HiddenClass::kNothing, {}, i});
  // Effects of some DOFs alone come last and in no pair: they leave the draws of the others alone.
  const auto all = EffectCatalogue();
  std::vector<const Effect*> catalogue(all.begin(), all.end());
  const auto first_of_some =
      std::stable_partition(catalogue.begin(), catalogue.end(), [](const Effect* effect) {
        return effect->info().acts_along == nullptr;
      });
  const auto num_of_any = static_cast<int>(first_of_some - catalogue.begin());
  for (const Effect* effect : catalogue) {
    for (int i = 0; i < sizes.per_effect; ++i)
      plans.push_back({HiddenClass::kOneEffect, {effect}, i});
  }
  Chance chance(seed, "hidden.pairs");
  for (int i = 0; i < sizes.two_effects; ++i) {
    int first = 0, second = 0;
    do {
      first = chance.Index(num_of_any);
      second = chance.Index(num_of_any);
    } while (first >= second ||
             !CanStandTogether(catalogue[first]->info(), catalogue[second]->info()));
    plans.push_back({HiddenClass::kTwoEffects, {catalogue[first], catalogue[second]}, i});
  }
  const auto unlisted = UnlistedEffects();
  for (int i = 0; i < sizes.unlisted; ++i) {
    plans.push_back({HiddenClass::kUnlisted, {unlisted[i % unlisted.size()]}, i});
  }
  return plans;
}

PlanSizes Scaled(const PlanSizes& sizes, double factor) {
  const auto scaled = [factor](int n) {
    return std::max(1, static_cast<int>(std::lround(factor * n)));
  };
  return {scaled(sizes.nothing),
          scaled(sizes.per_effect),
          scaled(sizes.two_effects),
          scaled(sizes.unlisted)};
}

}  // namespace fathom::hidden
