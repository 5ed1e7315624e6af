// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/motion/global_columns.h"
#include "fathom/joint_refinement/motion/lag.h"
#include "fathom/joint_refinement/motion/pose_chart.h"
#include "fathom/log/held_command.h"
#include "fathom/simulate/simulate.h"

#include <array>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What the excited DOF does in a typical moment; the response's regressors are divided by it.
struct MotionScales {
  double displacement = 1.0;  // [m] or [rad]
  double velocity = 1.0;      // [m/s] or [rad/s]
  double acceleration = 1.0;  // [m/s^2] or [rad/s^2]
};

// The unknowns that the mean motion of a segment follows from, as Ceres carries them.
struct MotionUnknowns {
  std::array<double, kModelColumns> model = {};    // [0]: log inertia
  std::array<double, 2> start = {};                // velocity, position
  std::array<double, kNumResponse> response = {};  // coordinate by coordinate
  double clock_offset = 0.0;                       // [s]

  UncoupledModel<double> Model() const;
};

// Where all six coordinates are expected at each frame of a segment: docs/joint_refinement.md (1)
// to (3).
//
//   eta_e = x(t)                                                  excited
//   eta_j = c_j0 + c_j1 (x - x_0)/X + c_j2 v/V + c_j3 a/A + sum_i c_j,3+i a_i/A     held
//
// a_i is the acceleration behind a lag of kResponseLags[i].
// One simulation, with its sensitivities, gives the means of all frames and their derivatives.
class PredictedMotion {
 public:
  // `time`: of the frames, by the camera's clock. `excited`: which coordinate the DOF moves.
  PredictedMotion(HeldCommand command,
                  std::vector<double> time,
                  int excited,
                  const MotionScales& scales);

  // Simulates. False if it diverges; the means then mean nothing.
  bool Update(const MotionUnknowns& unknowns);

  size_t size() const { return time_.size(); }
  const std::vector<double>& time() const { return time_; }

  // Of frame `k`, at the unknowns last given.
  PoseVector Mean(size_t k) const;
  double displacement(size_t k) const { return position_[node_[k]]; }
  double velocity(size_t k) const { return velocity_[node_[k]]; }

  // d Mean / d globals; the columns of the size and the mount are 0.
  using Derivatives = Eigen::Matrix<double, 6, kNumColumns>;
  Derivatives MeanDerivatives(size_t k) const;

  // The coordinate of eta that held slot `j` (0 to 4) stands for.
  int HeldCoordinate(int j) const { return j < excited_ ? j : j + 1; }

 private:
  static constexpr int kSensitivities = Simulation::kNumSensitivities;

  // Sensitivities and the clock.
  static constexpr int kSlopes = kSensitivities + 1;

  void LayOut(double clock_offset);
  void FollowWithLags();

  // Of frame k: displacement, velocity, acceleration and the lagged accelerations, each over its
  // scale; with their slopes, the model's with log inertia.
  Eigen::Vector<double, kNumRegressors> Regressors(size_t k) const;
  Eigen::Matrix<double, kNumRegressors, kSlopes> RegressorSlopes(size_t k) const;
  Eigen::Matrix<double, 3, kSlopes> StateSlopes(size_t node) const;

  HeldCommand command_;
  std::vector<double> time_;
  // Instants that are simulated: the frames, and between distant ones as many as the lags ask for.
  std::vector<size_t> node_;  // of each frame
  std::vector<double> nodes_;
  int excited_;
  MotionScales scales_;
  MotionUnknowns at_;
  bool is_laid_out_ = false;
  Simulation simulation_;
  std::vector<double> force_;  // at each node, as all below
  std::vector<double> position_, velocity_, acceleration_;
  std::vector<double> position_sensitivity_, velocity_sensitivity_;
  // The acceleration and its slopes behind each lag.
  std::array<SignalRows, kResponseLags.size()> lagged_;
};

}  // namespace fathom
