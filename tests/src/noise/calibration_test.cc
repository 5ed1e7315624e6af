// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the noise model is for: in a residual that misses nothing, the z-score of a column must be
// beyond 1.96 in 5 % of logs. The environment variable FATHOM_NOISE_DRAWS sets the number of logs
// per kind of noise and prints the table of docs/residual_noise.md for all variants.

#include "fathom/noise/fit_noise.h"
#include "fathom/noise/whitener.h"
#include "fathom/solve/decompositions.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "dense_covariance.h"
#include "null_noises.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kDuration = 300.0, kStep = 0.2;

// Responses of a vehicle with time constant 1 / 0.1 s to a force, as sensitivities are.
Eigen::VectorXd Response(const Eigen::VectorXd& force) {
  Eigen::VectorXd v(force.size());
  double state = 0.0;
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    v[i] = state;
    state += kStep * (force[i] - 0.1 * state);
  }
  return v;
}

struct Signatures {
  RowMajorMatrix design;   // what has been fitted already
  RowMajorMatrix columns;  // what is tested
};

constexpr std::array<const char*, 4> kColumns = {"ramp", "step", "sine", "random"};

Signatures MakeSignatures(const std::vector<NoiseSample>& samples) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::VectorXd t(n), step(n), random(n), ramp(n);
  std::mt19937 generator(77);
  std::normal_distribution<double> normal;
  double held = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    t[i] = samples[i].time;
    step[i] = t[i] > 0.5 * kDuration ? 1.0 : 0.0;
    ramp[i] = t[i] / kDuration;
    if (i % 20 == 0) held = normal(generator);
    random[i] = held;
  }
  Signatures s{RowMajorMatrix(n, 5), RowMajorMatrix(n, 4)};
  const double slow = 2.0 * 3.14159265 / 150.0;
  s.design << Eigen::VectorXd::Ones(n), (slow * t).array().sin().matrix(),
      (slow * t).array().cos().matrix(), Response(ramp),
      Response((0.11 * t).array().sin().matrix());
  s.columns << ramp, Response(step), (0.3 * t).array().sin().matrix(), Response(random);
  return s;
}

// Each column tested by itself after the design, by generalised least squares.
struct ScoredColumns {
  std::array<double, 4> z;
  std::array<double, 4> sharpness;  // expected z of an effect of size 1
};

ScoredColumns Score(const NoiseModel& model,
                    const std::vector<NoiseSample>& samples,
                    const Signatures& signatures,
                    const Eigen::VectorXd& e) {
  RowMajorMatrix all(e.size(), 10);
  all << signatures.design, signatures.columns, e;
  Whitener(model, samples).Apply(all, all);
  const Eigen::MatrixXd D = all.leftCols(5);
  const Eigen::MatrixXd Q = PivotedQr(D).QTimes(Eigen::MatrixXd::Identity(e.size(), 5));
  const Eigen::MatrixXd rest = all.rightCols(5) - Q * (Q.transpose() * all.rightCols(5));
  ScoredColumns scored;
  for (int c = 0; c < 4; ++c) {
    scored.sharpness[c] = rest.col(c).norm();
    scored.z[c] = rest.col(c).dot(rest.col(4)) / scored.sharpness[c];
  }
  return scored;
}

struct Variant {
  const char* name;
  bool restricted;
  std::optional<NoiseSelection> selection;  // none: the residual is taken for white
  bool is_oracle = false;
};

NoiseModel WhiteNoise(const Eigen::VectorXd& e) {
  NoiseModel white;
  white.velocity.white_std = std::sqrt(e.squaredNorm() / static_cast<double>(e.size()));
  return white;
}

// How the z-scores of one variant fared.
struct Tally {
  double num_scores = 0.0, beyond_196 = 0.0, beyond_3 = 0.0;
  std::array<double, 4> beyond_196_of_column = {};
  double sharpness = 0.0;  // sum of the expected z of a unit effect, relative to that of the truth

  void Add(const ScoredColumns& scored, const ScoredColumns& oracle) {
    for (int c = 0; c < 4; ++c) {
      num_scores += 1.0;
      beyond_196 += std::abs(scored.z[c]) > 1.96;
      beyond_196_of_column[c] += std::abs(scored.z[c]) > 1.96;
      beyond_3 += std::abs(scored.z[c]) > 3.0;
      sharpness += scored.sharpness[c] / oracle.sharpness[c];
    }
  }
};

struct Tallies {
  std::vector<Tally> of_variant;
  double num_unusable = 0.0;
  std::vector<double> seconds;

  void Print(const char* name) const {
    std::printf("| %-13s |", name);
    for (const Tally& tally : of_variant) {
      const double n = tally.num_scores / 100.0;
      std::printf(" %4.1f  %4.2f |", tally.beyond_196 / n, tally.beyond_3 / n);
    }
    std::printf("\n");
    std::fflush(stdout);
  }

  void Add(const Tallies& other) {
    for (size_t k = 0; k < of_variant.size(); ++k) {
      Tally& sum = of_variant[k];
      const Tally& tally = other.of_variant[k];
      sum.num_scores += tally.num_scores;
      sum.beyond_196 += tally.beyond_196;
      sum.beyond_3 += tally.beyond_3;
      sum.sharpness += tally.sharpness;
      for (int c = 0; c < 4; ++c) sum.beyond_196_of_column[c] += tally.beyond_196_of_column[c];
      seconds[k] += other.seconds[k];
    }
    num_unusable += other.num_unusable;
  }
};

Tallies ScoreDraws(const NullNoise& noise,
                   const std::vector<NoiseSample>& samples,
                   const std::vector<Variant>& variants,
                   int num_draws,
                   unsigned seed) {
  const Signatures signatures = MakeSignatures(samples);
  const PivotedQr qr(signatures.design);
  DenseDraws draws(noise.model, samples, seed);
  Tallies tallies{std::vector<Tally>(variants.size()), 0.0, std::vector<double>(variants.size())};
  for (int draw = 0; draw < num_draws; ++draw) {
    Eigen::VectorXd e = draws.Draw();
    e -= signatures.design * qr.Solve(e);
    const ScoredColumns oracle = Score(noise.model, samples, signatures, e);
    for (size_t k = 0; k < variants.size(); ++k) {
      if (variants[k].is_oracle) {
        tallies.of_variant[k].Add(oracle, oracle);
        continue;
      }
      if (!variants[k].selection) {
        tallies.of_variant[k].Add(Score(WhiteNoise(e), samples, signatures, e), oracle);
        continue;
      }
      FitNoiseOptions options;
      options.selection = *variants[k].selection;
      RowMajorMatrix design(e.size(), 0);
      if (variants[k].restricted) design = signatures.design;
      const auto start = std::chrono::steady_clock::now();
      const NoiseFit fit = FitNoise(samples, Span(e), design, options);
      const auto end = std::chrono::steady_clock::now();
      tallies.seconds[k] += std::chrono::duration<double>(end - start).count();
      tallies.num_unusable += !fit.IsUsable();
      tallies.of_variant[k].Add(Score(fit.model, samples, signatures, e), oracle);
    }
  }
  return tallies;
}

TEST(Calibration, FalseAlarmsAreAsManyAsPromised) {
  const auto samples = VelocitySamples(kDuration, kStep);
  const std::vector<Variant> variants = {{"default", true, FitNoiseOptions().selection},
                                         {"white", false, std::nullopt}};
  Tallies sum{std::vector<Tally>(2), 0.0, std::vector<double>(2)};
  const std::vector<NullNoise> noises = NullNoises();
  for (const unsigned kind : {0u, 1u, 6u, 9u, 12u}) {
    const Tallies tallies = ScoreDraws(noises[kind], samples, variants, 25, 100u + kind);
    tallies.Print(noises[kind].name.c_str());
    sum.Add(tallies);
  }
  sum.Print("all");
  EXPECT_EQ(sum.num_unusable, 0.0);
  // 500 scores, of which the four of a log may be correlated: as good as 250 at the least, whose
  // shares have standard deviations of 1.4 % and 0.33 %; three of these.
  EXPECT_NEAR(sum.of_variant[0].beyond_196 / 500.0, 0.05, 0.042);
  EXPECT_LT(sum.of_variant[0].beyond_3 / 500.0, 0.0027 + 3.0 * 0.0033);
  // What comes of the assumption that residuals are white.
  EXPECT_GT(sum.of_variant[1].beyond_196 / 500.0, 0.2);
}

TEST(Calibration, TableOfAllVariants) {
  const char* draws = std::getenv("FATHOM_NOISE_DRAWS");
  if (draws == nullptr) GTEST_SKIP() << "FATHOM_NOISE_DRAWS is not set.";
  const auto samples = VelocitySamples(kDuration, kStep);
  const std::vector<Variant> variants = {{"truth", true, NoiseSelection::kAic, true},
                                         {"ML white", false, std::nullopt},
                                         {"ML AIC", false, NoiseSelection::kAic},
                                         {"ML all", false, NoiseSelection::kAll},
                                         {"REML AIC", true, NoiseSelection::kAic},
                                         {"REML all", true, NoiseSelection::kAll}};
  const size_t num_variants = variants.size();
  std::printf("| %-13s |", "");
  for (const Variant& variant : variants) std::printf(" %-10s |", variant.name);
  std::printf("\n");
  Tallies sum{std::vector<Tally>(num_variants), 0.0, std::vector<double>(num_variants)};
  unsigned seed = 1;
  double num_logs = 0.0;
  for (const NullNoise& noise : NullNoises()) {
    const Tallies tallies = ScoreDraws(noise, samples, variants, std::atoi(draws), seed++);
    tallies.Print(noise.name.c_str());
    sum.Add(tallies);
    num_logs += std::atof(draws);
  }
  sum.Print("all");
  const auto print = [&](const char* name, const auto& value) {
    std::printf("| %-13s |", name);
    for (size_t k = 0; k < num_variants; ++k) std::printf(" %10.2f |", value(k));
    std::printf("\n");
  };
  for (size_t c = 0; c < 4; ++c) {
    print(kColumns[c],
          [&](size_t k) { return 100.0 * sum.of_variant[k].beyond_196_of_column[c] / num_logs; });
  }
  print("sharpness",
        [&](size_t k) { return sum.of_variant[k].sharpness / sum.of_variant[k].num_scores; });
  print("ms per fit", [&](size_t k) { return 1e3 * sum.seconds[k] / num_logs; });
  std::printf("not converged: %.0f\n", sum.num_unusable);
}

}  // namespace
}  // namespace fathom
