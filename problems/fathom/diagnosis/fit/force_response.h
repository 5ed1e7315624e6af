// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A fitted model's run on an even grid, linearised: what a small force adds to the outputs.
//
//   ds/dt = -a(t) s + f(t) / m,   a = (d_L + 2 d_Q |v|) / m        docs/diagnosis.md (5)
//
// A hundred times cheaper than a simulation; for screens, where many forces are tried.
class ForceResponse {
 public:
  // One instant of the run of one segment.
  struct Point {
    double time;      // log time [s]
    double velocity;  // simulated [m/s] or [rad/s]
    double position;  // simulated [m] or [rad]
    double command;   // [N] or [N m]
    int segment;
  };

  // `data` must outlive this. Diverging runs leave nothing: is_empty().
  ForceResponse(const TrainingData* data, const StructureFit& fit);

  bool is_empty() const { return points_.empty(); }
  const std::vector<Point>& points() const { return points_; }

  // What a force at every point adds to the outputs, by bins.
  Eigen::VectorXd Outputs(const std::vector<double>& force) const;

 private:
  const TrainingData* data_;
  double inertia_ = 1.0;
  std::vector<Point> points_;
  std::vector<double> kept_, given_;  // of the step that ends at a point: s' = kept s + given f
  std::vector<int> first_points_;     // by segment
};

}  // namespace fathom
