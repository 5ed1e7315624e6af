// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/joint_refinement/search/process_parameters.h"

#include <limits>
#include <span>

#include <Eigen/Core>

namespace fathom {

// The restricted likelihood of the processes over linearised segments, docs/joint_refinement.md
// (10), with wide bells on the logarithms that keep what the data do not determine within reason.
class ProcessLikelihood {
 public:
  // `parameters` at the centre of the bells.
  ProcessLikelihood(std::span<const LinearSegment> segments,
                    std::span<const GlobalsPrior> priors,
                    const ProcessParameters& parameters,
                    int excited);

  struct Value {
    bool is_usable = false;
    double value = 0.0;
    Eigen::VectorXd slope;
    // Minus the curvature that the likelihood would have if the states were known: an upper bound
    // of its own.
    Eigen::MatrixXd complete_information;
  };

  // Fisher's identity: the slope is the expected slope of the density of states and data together.
  // Not usable, and without a slope, where the likelihood is not above `least`.
  Value At(const Eigen::VectorXd& x,
           bool with_information,
           double least = -std::numeric_limits<double>::infinity()) const;

  const ProcessParameters& parameters() const { return parameters_; }
  int num_evaluations() const { return num_evaluations_; }

 private:
  std::span<const LinearSegment> segments_;
  std::span<const GlobalsPrior> priors_;
  ProcessParameters parameters_;
  int excited_;
  Eigen::VectorXd centre_, width_;
  mutable int num_evaluations_ = 0;
};

}  // namespace fathom
