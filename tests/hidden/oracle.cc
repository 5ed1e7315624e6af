// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "oracle.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "effect_size.h"
#include "known_noise_fit.h"
#include "rival_starts.h"

namespace fathom::hidden {
namespace {

class Oracle {
 public:
  explicit Oracle(const HiddenLog& hidden)
      : hidden_(hidden),
        run_(hidden.log,
             hidden.dof,
             hidden.truth.train_from,
             hidden.truth.train_to,
             hidden.truth.noise),
        scales_(ScalesOfRun(run_.inputs(), hidden.dof, hidden.truth.train_to)) {}

  OracleAnswer Answer() {
    const ExtendedModel& truth = hidden_.truth.model;
    const InitialState start = run_.FirstGuess();
    const KnownNoiseFit baseline = FitWithKnownNoise(run_, {truth.baseline, {}}, start);
    truth_ = FitWithKnownNoise(run_, truth, start);
    answer_.chi2_per_sample = truth_.chi2 / run_.num_samples();
    answer_.baseline_delta_bic = DeltaBic(baseline);
    answer_.held_out_baseline = HeldOutNmae(hidden_, baseline.model);
    answer_.held_out_truth = HeldOutNmae(hidden_, truth_.model);
    const HiddenClass hidden = hidden_.plan.hidden;
    if (hidden == HiddenClass::kUnlisted || !answer_.IsClear()) return answer_;
    answer_.rival_delta_bic = std::numeric_limits<double>::infinity();
    if (hidden == HiddenClass::kOneEffect) {
      TryInPlaceOf(baseline, truth.effects);
    } else {
      for (std::size_t kept = 0; kept < truth.effects.size(); ++kept) {
        // The other effect as it is, so that only the place of this one is open.
        ExtendedModel alone = {truth_.model.baseline, {truth_.model.effects[kept]}};
        const KnownNoiseFit fit = FitWithKnownNoise(run_, alone, truth_.initial);
        Count(fit, LabelOf(truth.effects[kept]));
        TryInPlaceOf(fit, truth.effects);
      }
    }
    return answer_;
  }

 private:
  // Above 0: the true structure is better.
  double DeltaBic(const KnownNoiseFit& fit) const {
    const double per_parameter = std::log(static_cast<double>(run_.num_samples()));
    return (fit.chi2 - truth_.chi2) / Excess() +
           per_parameter * (fit.num_effect_parameters - truth_.num_effect_parameters);
  }

  // The noise is known but for what turbulence does to a nonlinear vehicle: it may be larger.
  double Excess() const { return std::max(1.0, truth_.chi2 / run_.num_samples()); }

  void Count(const KnownNoiseFit& fit, const std::string& label) {
    const double delta = DeltaBic(fit);
    if (delta >= answer_.rival_delta_bic) return;
    answer_.rival_delta_bic = delta;
    answer_.rival = label;
  }

  // Every effect but the true ones, and true ones with another partner, on top of `fitted`.
  void TryInPlaceOf(const KnownNoiseFit& fitted, const std::vector<ActiveEffect>& truth) {
    for (const Effect* effect : EffectCatalogue()) {
      const EffectInfo& info = effect->info();
      if (!CanActAlong(info, hidden_.dof)) continue;
      if ((info.needs_pose || info.needs_displacement) && !run_.has_displacement()) continue;
      for (const Dof partner : PartnersOf(effect->info())) {
        ActiveEffect rival;
        rival.effect = effect;
        rival.setting = {hidden_.dof, partner, scales_.force[Index(hidden_.dof)]};
        const bool is_true = std::any_of(truth.begin(), truth.end(), [&](const ActiveEffect& t) {
          return t.effect == effect &&
                 (!effect->info().has_partner() || t.setting.partner == partner);
        });
        if (is_true || !answer_.IsSeparable()) continue;
        Try(fitted, rival);
      }
    }
  }

  void Try(const KnownNoiseFit& fitted, const ActiveEffect& rival) {
    std::string label = LabelOf(rival);
    for (const ActiveEffect& other : fitted.model.effects) label += "+" + LabelOf(other);
    const int num_parameters =
        fitted.num_effect_parameters + static_cast<int>(rival.effect->info().parameters.size());
    KnownNoiseFitOptions options;
    options.max_iterations = 20;
    // Anything above the bar, or above the best rival so far, need not be known exactly.
    options.wanted_chi2 =
        truth_.chi2 + Excess() * (std::min(100.0, answer_.rival_delta_bic) -
                                  std::log(static_cast<double>(run_.num_samples())) *
                                      (num_parameters - truth_.num_effect_parameters));
    for (const ExtendedModel& start : StartsFor(run_, fitted, scales_, rival)) {
      if (!answer_.IsSeparable()) return;
      Count(FitWithKnownNoise(run_, start, fitted.initial, options), label);
    }
  }

  // Those that move; any one if it has none.
  std::vector<Dof> PartnersOf(const EffectInfo& info) const {
    if (!info.has_partner()) return {Dof::kYaw};
    const bool turns = scales_.speed[Index(Dof::kYaw)] > 0.0 && hidden_.dof != Dof::kYaw;
    std::vector<Dof> partners;
    for (const Dof partner : kAllDofs) {
      if (partner == hidden_.dof || scales_.speed[Index(partner)] == 0.0) continue;
      const bool is_linear_pair = !IsAngular(partner) && !IsAngular(hidden_.dof);
      if (info.name == "coriolis_coupling" && !(turns && is_linear_pair)) continue;
      if (info.name == "lever_arm" &&
          !(IsAngular(partner) && !IsAngular(hidden_.dof) && hidden_.dof != Dof::kHeave))
        continue;
      if (info.name == "sensor_misalignment" && !is_linear_pair) continue;
      partners.push_back(partner);
    }
    return partners;
  }

  const HiddenLog& hidden_;
  const KnownRun run_;
  const RunScales scales_;
  KnownNoiseFit truth_;
  OracleAnswer answer_;
};

}  // namespace

OracleAnswer AskOracle(const HiddenLog& hidden) {
  if (hidden.plan.hidden == HiddenClass::kNothing) return {};
  const auto begin = std::chrono::steady_clock::now();
  OracleAnswer answer = Oracle(hidden).Answer();
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return answer;
}

double HeldOutNmae(const HiddenLog& hidden, const ExtendedModel& model) {
  const Truth& truth = hidden.truth;
  if (!(truth.held_out_to > truth.train_to)) return std::nan("");
  const KnownRun run(hidden.log, hidden.dof, truth.train_to, truth.held_out_to, truth.noise);
  KnownNoiseFitOptions options;
  options.start_only = true;
  const KnownNoiseFit fit = FitWithKnownNoise(run, model, run.FirstGuess(), options);
  return run.Nmae(fit.model, fit.initial);
}

}  // namespace fathom::hidden
