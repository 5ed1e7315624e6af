// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/random_stream.h"
#include "fathom/trends/dive_estimate.h"

#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

namespace fathom {

// The estimates of a vehicle's dives, drawn from their covariances.
struct DrawnArchive {
  int num_dives = 30;
  std::vector<Dof> dofs = {Dof::kSurge, Dof::kHeave, Dof::kYaw};
  ParameterVector truth{140.0, 60.0, 25.0, 4.0};
  ParameterVector std{2.0, 1.5, 1.2, 0.3};  // of a usual dive
  double least_factor = 0.5;                // of a dive's deviations, even in logarithm between
  double largest_factor = 2.5;              // these two
  double correlation = -0.8;                // between the two dampings
  ParameterVector tau = ParameterVector::Zero();  // between dives
};

inline ParameterCovariance DrawnCovariance(const DrawnArchive& archive, double factor) {
  ParameterCovariance correlation = ParameterCovariance::Identity();
  correlation(1, 2) = correlation(2, 1) = archive.correlation;
  correlation(0, 3) = correlation(3, 0) = 0.3;
  const ParameterVector std = factor * archive.std;
  return std.asDiagonal() * correlation * std.asDiagonal();
}

// Nothing changes in them. By dive, then DOF.
inline std::vector<DiveEstimate> DrawQuiet(const DrawnArchive& archive, RandomStream* random) {
  std::vector<DiveEstimate> estimates;
  for (int dive = 0; dive < archive.num_dives; ++dive) {
    for (const Dof dof : archive.dofs) {
      const double ratio = archive.largest_factor / archive.least_factor;
      const double factor = archive.least_factor * std::pow(ratio, random->Uniform());
      DiveEstimate estimate{dive, dof, archive.truth, DrawnCovariance(archive, factor)};
      ParameterVector white;
      for (double& number : white) number = random->Normal();
      estimate.value += estimate.covariance.llt().matrixL() * white;
      for (int p = 0; p < kNumParameters; ++p)
        estimate.value(p) += archive.tau(p) * random->Normal();
      estimates.push_back(estimate);
    }
  }
  return estimates;
}

// Coupled models of surge, sway and yaw, with the gain of one thruster and the righting moment in
// roll; correlations of 0.5 within each dive. By dive.
inline std::vector<DiveEstimate> DrawQuietCoupled(int num_dives, RandomStream* random) {
  const std::vector<FreeEntry> entries = {InertiaEntry(Dof::kSurge, Dof::kSurge),
                                          InertiaEntry(Dof::kSway, Dof::kSway),
                                          InertiaEntry(Dof::kYaw, Dof::kYaw),
                                          InertiaEntry(Dof::kSway, Dof::kYaw),
                                          LinearDampingEntry(Dof::kSurge, Dof::kSurge),
                                          LinearDampingEntry(Dof::kYaw, Dof::kYaw),
                                          RightingMomentEntry(Dof::kRoll),
                                          OffsetEntry(Dof::kYaw),
                                          ThrustGainEntry("lateral")};
  const auto size = static_cast<Eigen::Index>(entries.size());
  Eigen::VectorXd truth(size), std(size);
  truth << 140.0, 180.0, 12.0, 8.0, 60.0, 6.0, 20.0, 0.3, 1.0;
  std << 2.0, 2.0, 0.2, 0.3, 1.5, 0.1, 0.4, 0.02, 0.02;
  const Eigen::MatrixXd correlation =
      0.5 * (Eigen::MatrixXd::Identity(size, size) + Eigen::MatrixXd::Ones(size, size));
  std::vector<DiveEstimate> estimates;
  for (int dive = 0; dive < num_dives; ++dive) {
    DiveEstimate estimate;
    estimate.dive = dive;
    estimate.entries = entries;
    const Eigen::VectorXd own = std * (0.7 + 0.8 * random->Uniform());
    estimate.covariance = own.asDiagonal() * correlation * own.asDiagonal();
    Eigen::VectorXd white(size);
    for (double& number : white) number = random->Normal();
    estimate.value = truth + estimate.covariance.llt().matrixL() * white;
    estimates.push_back(estimate);
  }
  return estimates;
}

}  // namespace fathom
