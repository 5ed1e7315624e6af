// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/force_along_run.h"
#include "fathom/diagnosis/fit/structure_fit.h"

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A fitted model's run on an even grid, linearised: what a small force adds to the outputs.
//
//   ds/dt = -a(t) s - b(t) x + f(t) / m,   dx/dt = s               docs/diagnosis.md (5)
//   a = (d_L + 2 d_Q |v| + dR/dv) / m,     b = dR/dx / m
//
// with R the resistance of the effects that are forces in the water. A hundred times cheaper than a
// simulation; for screens, where many forces are tried.
class ForceResponse {
 public:
  // `data` must outlive this. Diverging runs leave nothing: is_empty().
  ForceResponse(const TrainingData* data, const StructureFit& fit);

  bool is_empty() const { return points_.empty(); }
  const std::vector<RunPoint>& points() const { return points_; }

  // What a force at every point adds to the outputs, by bins.
  Eigen::VectorXd Outputs(const std::vector<double>& force) const;

  // The same of a force that is known as its mean over the step that ends at a point; those of the
  // segments' first points are not looked at.
  Eigen::VectorXd OutputsOfMeans(const std::vector<double>& mean_force) const;

  // Of segment `index`: from first_point(index) up to first_point(index + 1).
  int first_point(std::size_t index) const { return first_points_[index]; }

 private:
  // The step that ends at a point.
  struct Step {
    double v_from_v = 1.0, v_from_x = 0.0, v_from_force = 0.0;
    double x_from_v = 0.0, x_from_x = 1.0, x_from_force = 0.0;
  };

  static Step StepOver(double h, double a, double b, double inertia);

  const TrainingData* data_;
  std::vector<RunPoint> points_;
  std::vector<Step> steps_;
  std::vector<int> first_points_;  // by segment
};

}  // namespace fathom
