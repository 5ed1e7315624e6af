// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/search/screen/trials.h"
#include "fathom/noise/whitener.h"

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The columns of trials under one noise: whitened, cleared of what the fitted model can imitate,
// and of length 1 (orthogonal within a trial); docs/diagnosis.md (4).
class Screen {
 public:
  // `trials` must outlive this.
  Screen(const StructureFit& fit, const Trials* trials, const Whitener& whitener);

  // By how much chi squared would fall, linearly, for each trial; 0 where the sign is wrong.
  const std::vector<double>& scores() const { return scores_; }

  // The trial's amounts that the linear screen finds, in units of its probes.
  const std::vector<std::vector<double>>& amounts() const { return amounts_; }

  // Of a trial with one column c, so many times as large: chi squared falls by
  // 2 times inner - times^2 squared. Both 0 where nothing of it is left.
  struct Response {
    double inner = 0.0;    // c' r
    double squared = 0.0;  // c' c
  };
  const Response& response(int trial) const { return responses_[trial]; }

  // Scores of every two of some trials taken together; 0 of one with itself.
  Eigen::MatrixXd PairScores(const std::vector<int>& some) const;

  // Draws of each suspect's greatest score where nothing is missing: a row per draw, a column per
  // suspect.
  Eigen::MatrixXd NullMaxima(int num_draws, int num_suspects, std::uint64_t seed) const;

 private:
  const Trials* trials_;
  Eigen::MatrixXd unit_;       // rows: bins
  Eigen::VectorXd projected_;  // unit' residual
  std::vector<double> scores_;
  std::vector<std::vector<double>> amounts_;
  std::vector<Response> responses_;
};

}  // namespace fathom
