// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_structure.h"
#include "fathom/noise/restricted_likelihood.h"

#include <Eigen/Core>

namespace fathom {

// Maximises the likelihood of one noise structure after another, and counts its evaluations.
class NoiseSearch {
 public:
  struct Point {
    Eigen::VectorXd parameters;
    RestrictedLikelihood::Value value;
  };

  struct Result {
    NoiseStructure structure;
    Point best;
    bool converged = false;

    double log_likelihood() const { return best.value.log_likelihood; }
  };

  // The likelihood must outlive this object.
  explicit NoiseSearch(const RestrictedLikelihood& likelihood) : likelihood_(likelihood) {}

  int num_evaluations() const { return num_evaluations_; }

  Point At(const NoiseStructure& structure, Eigen::VectorXd parameters);

  // The maximum uphill of `start`, which is within the bounds: from Fisher's information as the
  // first guess of the curvature, BFGS with Levenberg's damping; docs/residual_noise.md (12). It
  // ends where a step would raise the log-likelihood by less than `worthwhile`.
  Result From(const NoiseStructure& structure, const Eigen::VectorXd& start, double worthwhile);

 private:
  // Gradient of the log-likelihood and, where asked for, its expected negative curvature, the
  // common factor on all standard deviations eliminated.
  void Differentiate(const NoiseStructure& structure,
                     const Point& at,
                     Eigen::VectorXd* gradient,
                     Eigen::MatrixXd* information);

  const RestrictedLikelihood& likelihood_;
  int num_evaluations_ = 0;
};

}  // namespace fathom
