// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "oracle.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>

#include "known_noise_fit.h"
#include <gtest/gtest.h>

namespace fathom::hidden {
namespace {

constexpr std::uint64_t kOracleSeed = 7;

HiddenLog Draw(const char* effect, int number) {
  return DrawHiddenLog({HiddenClass::kOneEffect, {FindEffect(effect)}, number}, kOracleSeed);
}

// At the truth itself the whitened residual is white noise of variance 1: generator, simulation and
// noise model agree.
TEST(Oracle, SeesNothingButNoiseAtTheTruth) {
  int num_logs = 0;
  for (const Effect* effect : EffectCatalogue()) {
    const HiddenLog hidden = DrawHiddenLog({HiddenClass::kOneEffect, {effect}, 0}, kOracleSeed);
    // The response of a nonlinear vehicle to turbulence is only about that of the noise model.
    if (hidden.truth.noise.model.disturbance.IsPresent()) continue;
    ++num_logs;
    const KnownRun run(
        hidden.log, hidden.dof, hidden.truth.train_from, hidden.truth.train_to, hidden.truth.noise);
    // Only the start is fitted, which costs two samples.
    KnownNoiseFitOptions options;
    options.start_only = true;
    const double chi2 = FitWithKnownNoise(run, hidden.truth.model, run.FirstGuess(), options).chi2;
    const double n = run.num_samples();
    // A partner's reading is noisy, too, which the dynamics pass on: 10 % more.
    const double more = effect->info().has_partner() ? 0.1 * n : 0.0;
    EXPECT_NEAR(chi2, n, 4.5 * std::sqrt(2.0 * n) + more) << hidden.truth.setup;
  }
  EXPECT_GT(num_logs, 10);
}

TEST(Oracle, FindsALargeStepOfBuoyancyClearAndSeparable) {
  // The first of ten whose signature is over 20 deviations.
  for (int number = 0; number < 10; ++number) {
    const HiddenLog hidden = Draw("buoyancy_step", number);
    if (hidden.truth.signature[0] < 20.0) continue;
    const OracleAnswer answer = AskOracle(hidden);
    EXPECT_TRUE(answer.IsClear());
    EXPECT_TRUE(answer.IsSeparable()) << answer.rival;
    return;
  }
  FAIL() << "no log with a large step";
}

// Identical at every speed without a pose: EFFECTS' exact equivalence.
TEST(Oracle, CannotTellABiasFromACurrentWithoutAPose) {
  int num_logs = 0;
  for (int number = 0; number < 8; ++number) {
    const HiddenLog hidden = Draw("sensor_bias", number);
    if (hidden.truth.noise.use_poses) continue;
    const OracleAnswer answer = AskOracle(hidden);
    if (!answer.IsClear()) continue;
    ++num_logs;
    EXPECT_FALSE(answer.IsSeparable()) << hidden.truth.setup;
  }
  EXPECT_GT(num_logs, 0);
}

}  // namespace
}  // namespace fathom::hidden
