// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// An effect that the library does not know, hidden in a log, and named by a diagnosis that was told
// of it; docs/adding_an_effect.md. And one of which other DOFs take part, by the rule that it
// states.

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/synthesize/effects/parse_hidden_effects.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "square_root_drag.h"
#include "surge_run.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kCoefficient = 40.0;

std::vector<Log> LogsWith(const Effect* effect) {
  SurgeRun run;
  run.input = Steps({60.0, 5.0, -20.0, -60.0, 10.0, 30.0, -5.0, 0.0}, 12.0);
  run.duration = 200.0;
  run.velocity_noise = 0.003;
  run.more = {{effect, {}, {kCoefficient}}};
  return {LogOf(run, 1)};
}

TEST(OutsideEffect, IsNamedByADiagnosisThatKnowsIt) {
  static const Effect square_root_drag = EffectOf<SquareRootDrag>();
  DiagnosisOptions options;
  options.effects.assign(EffectCatalogue().begin(), EffectCatalogue().end());
  options.effects.push_back(&square_root_drag);
  const Diagnosis diagnosis = Diagnose(LogsWith(&square_root_drag), Dof::kSurge, options);
  EXPECT_EQ(diagnosis.verdict, Verdict::kExplained);
  ASSERT_EQ(diagnosis.causes.size(), 1u);
  EXPECT_TRUE(diagnosis.causes[0].alternatives.empty());
  const ActiveEffect& named = diagnosis.extended.model.effects.at(0);
  EXPECT_EQ(named.effect, &square_root_drag);
  EXPECT_NEAR(named.values[0], kCoefficient, 4.0 * std::sqrt(diagnosis.extended.covariance(4, 4)));
  EXPECT_LT(std::sqrt(diagnosis.extended.covariance(4, 4)), 0.2 * kCoefficient);
}

TEST(OutsideEffect, IsNotNamedByADiagnosisThatDoesNot) {
  static const Effect square_root_drag = EffectOf<SquareRootDrag>();
  const Diagnosis diagnosis = Diagnose(LogsWith(&square_root_drag), Dof::kSurge);
  for (const ActiveEffect& active : diagnosis.extended.model.effects) {
    EXPECT_NE(active.effect, &square_root_drag);
  }
  EXPECT_NE(diagnosis.verdict, Verdict::kConsistent);
}

// A wall that is not still: the marker goes to and fro by 10 cm a minute. No effect of the
// catalogue does, and the velocities know nothing of it; the page needs the poses to show it.
TEST(OutsideEffect, IsShownInThePosesTooWhereNothingExplainsIt) {
  constexpr double kSwing = 0.1, kFrequency = 0.1;  // [m], [rad/s]
  SurgeRun run;
  run.input = Multisine(40.0);
  run.duration = 200.0;
  run.has_poses = true;
  Log log = LogOf(run, 1);
  const auto x = std::find(log.pose->columns.begin(), log.pose->columns.end(), "x");
  std::vector<double>& position = log.pose->values[x - log.pose->columns.begin()];
  for (size_t k = 0; k < position.size(); ++k) {
    position[k] += kSwing * std::sin(kFrequency * log.pose->time[k]);
  }
  const Diagnosis diagnosis = Diagnose(std::vector<Log>{log}, Dof::kSurge);
  EXPECT_EQ(diagnosis.verdict, Verdict::kUnexplained);
  ASSERT_EQ(diagnosis.pose_traces.size(), 1u);
  EXPECT_EQ(diagnosis.pose_traces[0].time, log.pose->time);
  EXPECT_EQ(diagnosis.pose_traces[0].measured, position);
}

// A force by a rotation about the axis of the motion: surge and roll, sway and pitch, heave and
// yaw.
struct ScrewForce {
  static EffectInfo Info() {
    return {.name = "screw_force",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "coefficient",
                            .quantity = {"N s/rad", "N m s/rad", 1, -1, 0},
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.1, 1.0, natural::Coupling, true}}},
            .partner = PartnerInfo{.rule = IsAboutItsAxis, .velocity = true},
            .cause = "a hull that turns as a screw",
            .advice = "Keep it."};
  }
  static bool IsAboutItsAxis(Dof dof, Dof partner) { return Index(partner) == Index(dof) + 3; }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>&, const Instant<T>& now) {
      return p[0] * now.partner.velocity;
    }};
  }
};

// Whether fathom_synthesize hides it: every DOF is driven.
bool IsHiddenWith(const Effect* effect, Dof dof, Dof partner) {
  Experiment experiment;
  std::array<Scales, 6> scales;
  for (const Dof driven : kAllDofs) {
    experiment.drives.push_back({.dof = driven, .input = {}, .pid = {}});
    scales[Index(driven)] = {10.0, 20.0, 1.0, 0.5, 1.0, 2.0, 100.0};
  }
  const std::string text =
      fmt::format("{}.{}:partner={}", Name(dof), effect->info().name, Name(partner));
  try {
    const auto hidden = ParseHiddenEffects(text, experiment, scales, 1, std::span(&effect, 1));
    return hidden.at(0).setting.partner == partner;
  } catch (const InputError&) {
    return false;
  }
}

// Whether fathom_diagnose looks for it: every DOF is commanded and moves.
bool IsSuspectWith(const Effect* effect, Dof dof, Dof partner) {
  EffectInputs inputs;
  inputs.dof = dof;
  inputs.command = {{0.0, 1.0}, {2.0, 3.0}};
  inputs.force.fill(inputs.command);
  MeasuredSegments segments;
  segments.has_displacement = true;
  segments.all.emplace_back();
  segments.all[0].inputs = std::make_shared<const EffectInputs>(inputs);
  segments.partners.assign(kAllDofs.begin(), kAllDofs.end());
  const auto suspects = SuspectsFor(segments, dof, std::span(&effect, 1));
  return std::any_of(suspects.begin(), suspects.end(), [&](const Suspect& suspect) {
    return suspect.effect->info().has_partner() && suspect.setting.partner == partner;
  });
}

TEST(OutsideEffect, IsHiddenAndLookedForWithTheSamePartnersAsAnyOther) {
  static const Effect screw_force = EffectOf<ScrewForce>();
  std::vector<const Effect*> effects(EffectCatalogue().begin(), EffectCatalogue().end());
  effects.push_back(&screw_force);
  for (const Effect* effect : effects) {
    int num_pairs = 0;
    for (const Dof dof : kAllDofs) {
      for (const Dof partner : kAllDofs) {
        const bool may_be = CanBePartner(effect->info(), dof, partner);
        num_pairs += may_be ? 1 : 0;
        EXPECT_EQ(IsHiddenWith(effect, dof, partner), may_be)
            << effect->info().name << ", " << Name(dof) << ", " << Name(partner);
        EXPECT_EQ(IsSuspectWith(effect, dof, partner), may_be)
            << effect->info().name << ", " << Name(dof) << ", " << Name(partner);
      }
    }
    EXPECT_EQ(num_pairs > 0, effect->info().has_partner()) << effect->info().name;
  }
  EXPECT_TRUE(IsHiddenWith(&screw_force, Dof::kHeave, Dof::kYaw));
  EXPECT_TRUE(IsSuspectWith(&screw_force, Dof::kHeave, Dof::kYaw));
  EXPECT_FALSE(IsSuspectWith(&screw_force, Dof::kSurge, Dof::kYaw));
}

}  // namespace
}  // namespace fathom
