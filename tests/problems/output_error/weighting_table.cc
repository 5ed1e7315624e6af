// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The table of docs/output_error.md: errors and coverage by kind of noise and weighting.
//
//   weighting_table [logs of each kind] [first seed] [part of a kind's name]

#include "fathom/output_error/weighting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "noise_trial.h"

namespace fathom {
namespace {

// What one estimator did on all logs of a kind.
struct Score {
  std::array<std::vector<double>, kNumParameters> errors;  // sizes
  ParameterVector covered = ParameterVector::Zero();
  int num_logs = 0;
};

void Add(const ParameterVector& error, const ParameterVector& std, Score* score) {
  for (int i = 0; i < kNumParameters; ++i) {
    const double size = std::abs(error[i]);
    score->errors[i].push_back(size);
    score->covered[i] += size <= 1.96 * std[i] ? 1.0 : 0.0;
  }
  ++score->num_logs;
}

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double RootMeanSquareOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void PrintRow(const char* kind, const char* estimator, const Score& score, const Score& oracle) {
  std::printf("| %s | %s |", kind, estimator);
  for (int i = 0; i < kNumParameters; ++i) {
    std::printf(" %.2f", MedianOf(score.errors[i]) / MedianOf(oracle.errors[i]));
  }
  std::printf(" |");
  for (int i = 0; i < kNumParameters; ++i) {
    std::printf(" %.2f", RootMeanSquareOf(score.errors[i]) / RootMeanSquareOf(oracle.errors[i]));
  }
  std::printf(" |");
  for (int i = 0; i < kNumParameters; ++i) {
    std::printf(" %.1f", 100.0 * score.covered[i] / score.num_logs);
  }
  std::printf(" |\n");
}

void Run(const NoiseKind& kind, int num_logs, unsigned first_seed) {
  constexpr std::array kWeightings = {Weighting::kPlain, Weighting::kLearned};
  const NoiseTrial trial(kind);
  const ParameterVector truth = ToVector(trial.truth());
  const ParameterVector oracle_std = trial.OracleStd();
  Score oracle;
  std::array<Score, kWeightings.size()> scores;
  for (int k = 0; k < num_logs; ++k) {
    const Segment segment = trial.Draw(first_seed + k);
    Add(trial.Oracle(segment) - truth, oracle_std, &oracle);
    for (size_t w = 0; w < kWeightings.size(); ++w) {
      OutputErrorOptions options;
      options.initial_guess = trial.truth();
      options.output = kind.output;
      options.weighting = kWeightings[w];
      const auto fit = FitOutputError({&segment, 1}, options);
      if (!fit.IsUsable()) continue;
      Add(ToVector(fit.model) - truth, fit.covariance.diagonal().cwiseSqrt(), &scores[w]);
    }
  }
  PrintRow(kind.name.c_str(), "oracle", oracle, oracle);
  for (size_t w = 0; w < kWeightings.size(); ++w) {
    PrintRow("", Name(kWeightings[w]).data(), scores[w], oracle);
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  const int num_logs = argc > 1 ? std::atoi(argv[1]) : 200;
  const unsigned first_seed = argc > 2 ? std::atoi(argv[2]) : 1;
  const std::string part = argc > 3 ? argv[3] : "";
  std::printf(
      "| noise | weights | median error over the oracle's | RMS error over the oracle's | "
      "coverage [%%] |\n| --- | --- | --- | --- | --- |\n");
  for (const fathom::NoiseKind& kind : fathom::AllNoiseKinds()) {
    if (kind.name.find(part) != std::string::npos) fathom::Run(kind, num_logs, first_seed);
  }
}
