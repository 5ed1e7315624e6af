// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What noise alone reaches, suspect by suspect: one that is tried at many times or frequencies must
// gain more than one that is tried once. docs/diagnosis.md (7).
class Significance {
 public:
  // Nothing is ever significant.
  Significance() = default;

  // `null_maxima`: draws of each suspect's greatest gain where nothing is missing, a row per draw;
  // `num_amounts`: by suspect, 1 or 2; `caution`: by suspect, at least 1, as if it were tried so
  // many times as often as the draws show.
  Significance(const Eigen::MatrixXd& null_maxima,
               std::vector<int> num_amounts,
               const std::vector<double>& caution,
               double false_alarm_rate);

  // Probability that noise alone lets this suspect gain as much.
  double PValue(int suspect, double gain) const;

  // Probability that noise alone lets any suspect gain something as rare.
  double FamilyWisePValue(int suspect, double gain) const;

  // Gain of this suspect at which the family-wise p-value is the false alarm rate.
  double Threshold(int suspect) const {
    return thresholds_.empty() ? kNever : thresholds_[suspect];
  }

  // The same for a cause named beside others: it must be fifteen times as rare. One effect that is
  // not quite of its catalogue's form should not bring in a second.
  double ThresholdBeside(int suspect) const {
    return thresholds_beside_.empty() ? kNever : thresholds_beside_[suspect];
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  // Gain of the suspect at which its p-value among all is `rate`.
  double ThresholdAt(int suspect, double rate) const;

  std::vector<int> num_amounts_;
  std::vector<double> num_tests_;  // independent ones that the suspect's trials amount to
  double num_families_ = 1.0;      // independent suspects that all suspects amount to
  std::vector<double> thresholds_, thresholds_beside_;
};

}  // namespace fathom
