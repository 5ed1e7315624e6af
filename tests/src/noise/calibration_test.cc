// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the noise model is for: in a residual that misses nothing, the z-score of a column must be
// beyond 1.96 in 5 % of logs. The environment variable FATHOM_NOISE_DRAWS sets the number of logs
// per kind of noise and prints the table of docs/residual_noise.md for all variants.

#include "fathom/noise/fit_noise.h"
#include "fathom/noise/whitener.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "dense_covariance.h"
#include <Eigen/QR>
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

// z-scores of the columns, each tested by itself after the design, by generalised least squares.
Eigen::VectorXd Scores(const NoiseModel& model,
                       const std::vector<NoiseSample>& samples,
                       const Signatures& signatures,
                       const Eigen::VectorXd& e) {
  RowMajorMatrix all(e.size(), 10);
  all << signatures.design, signatures.columns, e;
  Whitener(model, samples).Apply(all, all);
  const Eigen::MatrixXd D = all.leftCols(5);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(D);
  const Eigen::MatrixXd Q = qr.householderQ() * Eigen::MatrixXd::Identity(e.size(), 5);
  const Eigen::MatrixXd rest = all.rightCols(5) - Q * (Q.transpose() * all.rightCols(5));
  Eigen::VectorXd z(4);
  for (int k = 0; k < 4; ++k) z[k] = rest.col(k).dot(rest.col(4)) / rest.col(k).norm();
  return z;
}

struct Noise {
  std::string name;
  NoiseModel model;
};

std::vector<Noise> Noises(bool all) {
  std::vector<Noise> noises;
  NoiseModel model;
  model.velocity.white_std = 0.02;
  noises.push_back({"white", model});
  // AR(1) 0.9 at 10 Hz.
  model.velocity = {.white_std = 1e-6, .coloured = {.std = 0.02, .time = -0.1 / std::log(0.9)}};
  noises.push_back({"AR(1) 0.9", model});
  for (const double ratio : {0.1, 0.3, 1.0, 2.0}) {
    for (const double tau : {1.0, 3.0, 10.001, 30.0}) {
      if (!all && (ratio == 0.1 || ratio == 2.0 || tau == 3.0)) continue;
      NoiseModel disturbed;
      disturbed.velocity.white_std = 0.02;
      disturbed.damping_rate = 0.1;
      disturbed.disturbance = {.std = 1.0, .time = tau};
      disturbed.disturbance.std = ratio * 0.02 / disturbed.DisturbedVelocityStd();
      char name[64];
      std::snprintf(name, sizeof(name), "%.1f, tau %.0f s", ratio, tau);
      noises.push_back({name, disturbed});
    }
  }
  return noises;
}

struct Variant {
  const char* name;
  bool restricted;
  NoiseSelection selection;
  bool is_oracle = false;
};

void PrintTable(const std::vector<Variant>& variants, int num_draws, bool all) {
  const auto samples = VelocitySamples(kDuration, kStep);
  const Signatures signatures = MakeSignatures(samples);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(signatures.design);
  std::vector<double> seconds(variants.size());
  std::vector<std::array<int, 4>> totals(variants.size());
  int num_logs = 0;
  for (const Noise& noise : Noises(all)) {
    DenseDraws draws(noise.model, samples, 4321 + static_cast<unsigned>(num_logs));
    std::vector<std::array<int, 4>> hits(variants.size());
    std::vector<std::array<double, 4>> squares(variants.size());
    for (int draw = 0; draw < num_draws; ++draw) {
      const Eigen::VectorXd e = draws.Draw();
      Eigen::VectorXd projected = qr.solve(e);
      projected = e - signatures.design * projected;
      for (size_t k = 0; k < variants.size(); ++k) {
        FitNoiseOptions options;
        options.selection = variants[k].selection;
        NoiseModel model = noise.model;
        if (!variants[k].is_oracle) {
          const auto start = std::chrono::steady_clock::now();
          const NoiseFit fit = FitNoise(
              samples,
              Span(projected),
              variants[k].restricted ? signatures.design : RowMajorMatrix(samples.size(), 0),
              options);
          seconds[k] +=
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
          EXPECT_TRUE(fit.IsUsable()) << noise.name << " " << draw << " " << fit.message;
          model = fit.model;
        }
        const Eigen::VectorXd z = Scores(model, samples, signatures, projected);
        for (int c = 0; c < 4; ++c) {
          hits[k][c] += std::abs(z[c]) > 1.96;
          squares[k][c] += z[c] * z[c];
        }
      }
    }
    num_logs += num_draws;
    for (size_t k = 0; k < variants.size(); ++k) {
      std::printf("| %-13s | %-12s |", noise.name.c_str(), variants[k].name);
      for (int c = 0; c < 4; ++c) {
        totals[k][c] += hits[k][c];
        std::printf(" %4.1f (%.2f) |",
                    100.0 * hits[k][c] / num_draws,
                    std::sqrt(squares[k][c] / num_draws));
      }
      std::printf("\n");
    }
    std::fflush(stdout);
  }
  for (size_t k = 0; k < variants.size(); ++k) {
    std::printf("| %-13s | %-12s |", "all", variants[k].name);
    for (int c = 0; c < 4; ++c) std::printf(" %4.1f        |", 100.0 * totals[k][c] / num_logs);
    std::printf(" %.1f ms per fit\n", 1e3 * seconds[k] / num_logs);
  }
}

TEST(Calibration, Table) {
  const char* draws = std::getenv("FATHOM_NOISE_DRAWS");
  PrintTable({{"oracle", true, NoiseSelection::kAic, true},
              {"ML white", false, NoiseSelection::kWhite},
              {"ML AIC", false, NoiseSelection::kAic},
              {"ML all", false, NoiseSelection::kAll},
              {"REML AIC", true, NoiseSelection::kAic},
              {"REML BIC", true, NoiseSelection::kBic},
              {"REML all", true, NoiseSelection::kAll}},
             draws != nullptr ? std::atoi(draws) : 10,
             draws != nullptr);
}

}  // namespace
}  // namespace fathom
