// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"
#include "fathom/noise/whitener.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// How it is decided which of coloured velocity noise, coloured displacement noise and disturbance
// there are, beside white noise. docs/residual_noise.md has the false alarms of each.
enum class NoiseSelection {
  kAic,  // each two parameters must raise the log-likelihood by 2
  kAll,  // all of them, however weak
};

struct FitNoiseOptions {
  NoiseSelection selection = NoiseSelection::kAll;

  // a of the model [1/s], above 0: not fitted, known from the vehicle's parameters.
  double damping_rate = 0.1;

  // Longest correlation time, as a share of the longest segment; slower noise is confounded with
  // the model. Above 0.
  double longest_time = 0.25;

  // How near to the greatest log-likelihood a fit must come. Above 0.
  double precision = 1e-4;

  // Where the search starts, and which components there are: nothing is selected then. For fits
  // that follow one another; several times faster.
  std::optional<NoiseModel> start;

  // Whether colour of hardly more than a sample is tried as white noise too, which is a maximum of
  // its own.
  bool is_thorough = false;

  // One line for each rule that is broken; empty if these options can be used.
  std::vector<std::string> Problems() const;
};

// Numbers that were not computed are NaN, never zero.
struct NoiseFit {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  // True if the search converged.
  bool IsUsable() const { return converged; }

  std::string message = "FitNoise() was not called.";
  bool converged = false;
  NoiseModel model;
  double log_likelihood = kNotComputed;  // restricted where there is a design
  int num_parameters = -1;
  int num_evaluations = -1;
};

// The noise model of greatest likelihood for a residual, docs/residual_noise.md (8). `design` has a
// row per sample and a column for everything that has been fitted to the data already
// (sensitivities of the parameters and of the start): the likelihood is then the restricted one, of
// what no combination of these columns can explain, docs/residual_noise.md (9). The residual need
// not be projected. No columns: plain maximum likelihood. Columns that depend on one another count
// once.
NoiseFit FitNoise(std::span<const NoiseSample> samples,
                  std::span<const double> residual,
                  const Eigen::Ref<const RowMajorMatrix>& design,
                  const FitNoiseOptions& options);

}  // namespace fathom
