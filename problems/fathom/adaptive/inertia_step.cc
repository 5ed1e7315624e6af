// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/inertia_step.h"

#include "fathom/simulate/run_start.h"
#include "fathom/simulate/simulate.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/parameters.h"

#include <limits>
#include <vector>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kColumns = Simulation::kNumSensitivities;

// J'J and J'r of the parameters, with each segment's initial speed eliminated.
struct Normal {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
};

// False if the simulation diverges.
bool AddSegment(const UncoupledModel<double>& model, const Segment& segment, Normal* normal) {
  const auto n = static_cast<Eigen::Index>(segment.time.size());
  std::vector<double> v(segment.time.size());
  Eigen::Matrix<double, Eigen::Dynamic, kColumns, Eigen::RowMajor> J(n, kColumns);
  const Simulation simulation(segment.command, segment.time);
  if (!simulation.RunWithSensitivities(model,
                                       {InitialVelocity(segment)},
                                       v,
                                       {},
                                       {J.data(), static_cast<size_t>(J.size())},
                                       {})) {
    return false;
  }
  const Eigen::VectorXd miss =
      Eigen::VectorXd::Map(segment.velocity.data(), n) - Eigen::VectorXd::Map(v.data(), n);
  const Eigen::Matrix<double, kColumns, kColumns> JtJ = J.transpose() * J;
  const Eigen::Vector<double, kColumns> Jtr = J.transpose() * miss;
  const Eigen::Vector4d eliminate = JtJ.topRightCorner<4, 1>() / JtJ(4, 4);
  normal->A += JtJ.topLeftCorner<4, 4>() - eliminate * JtJ.bottomLeftCorner<1, 4>();
  normal->b += Jtr.head<4>() - eliminate * Jtr[4];
  return true;
}

}  // namespace

double InertiaStep(const UncoupledModel<double>& model, std::span<const Segment> segments) {
  Normal normal;
  for (const Segment& segment : segments) {
    if (segment.time.size() < 2) continue;
    if (!AddSegment(model, segment, &normal)) return kNaN;
  }
  const Eigen::Vector4d unscale = normal.A.diagonal().cwiseSqrt().cwiseInverse();
  const SymmetricEigen eigen = EigenOf(unscale.asDiagonal() * normal.A * unscale.asDiagonal());
  if (!(eigen.values.minCoeff() > 1e-13 * eigen.values.maxCoeff())) return kNaN;
  const Eigen::VectorXd along =
      (eigen.vectors.transpose() * (unscale.asDiagonal() * normal.b)).cwiseQuotient(eigen.values);
  const Eigen::Vector4d step = unscale.asDiagonal() * (eigen.vectors * along);
  return step[kInertia] / model.inertia;
}

}  // namespace fathom
