// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/export_checks.h"

#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/coriolis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLetGoAt = 0.5;        // [m/s] or [rad/s]
constexpr double kTimeConstants = 5.0;  // that a decay runs over
constexpr int kNumEnergies = 200;

double SmallestEigenvalue(const CoupledModel& model) {
  const auto size = static_cast<Eigen::Index>(model.dofs.size());
  Eigen::MatrixXd part(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      part(i, j) = model.inertia(Index(model.dofs[static_cast<std::size_t>(i)]),
                                 Index(model.dofs[static_cast<std::size_t>(j)]));
    }
  }
  return LeastEigenvalue(part);
}

// Velocities of the modelled DOFs that no symmetry hides anything at.
Vector6 DrawnVelocity(const CoupledModel& model, int draw) {
  Vector6 nu = Vector6::Zero();
  for (const Dof dof : model.dofs) nu[Index(dof)] = std::sin(1.0 + 1.7 * draw + 2.3 * Index(dof));
  return nu;
}

// The work of C(nu) over what its parts do without regard to sign.
double LargestWorkOfCoriolis(const CoupledModel& model) {
  double largest = 0.0;
  for (int draw = 0; draw < 10; ++draw) {
    const Vector6 nu = DrawnVelocity(model, draw);
    const Vector6 force = CoriolisForce(model.inertia, nu);
    const double scale = nu.cwiseAbs().dot(force.cwiseAbs());
    if (scale > 0.0) largest = std::max(largest, std::abs(nu.dot(force)) / scale);
  }
  return largest;
}

// How long the slowest DOF alone takes [s]; infinite where one has no damping.
double SlowestTimeConstant(const CoupledModel& model) {
  double slowest = 0.0;
  for (const Dof dof : model.dofs) {
    const auto i = Index(dof);
    const double damping = model.linear_damping(i, i) + model.quadratic_damping(i, i) * kLetGoAt;
    slowest = std::max(slowest, damping > 0.0 ? model.inertia(i, i) / damping : INFINITY);
  }
  return slowest;
}

double EnergyOf(const CoupledModel& model, const Vector6& nu) {
  return 0.5 * nu.dot(model.inertia * nu);
}

// What is wrong with the decay from a speed along one DOF; empty: nothing.
std::string ProblemWithDecay(const CoupledModel& model, Dof dof, double duration) {
  CoupledState start;
  start.nu[Index(dof)] = kLetGoAt;
  CoupledStamps stamps;
  for (int k = 0; k <= kNumEnergies; ++k) stamps.velocity.push_back(duration * k / kNumEnergies);
  CoupledOutputs outputs;
  if (!RunCoupled(model, {}, start, stamps, &outputs)) {
    return fmt::format("A free decay from {} {} of {} diverges, or is too stiff to run.",
                       kLetGoAt,
                       VelocityUnit(dof),
                       Name(dof));
  }
  const double first = EnergyOf(model, outputs.velocity.front());
  double last = first;
  for (std::size_t k = 1; k < outputs.velocity.size(); ++k) {
    const double energy = EnergyOf(model, outputs.velocity[k]);
    // The scheme's own error is far smaller.
    if (energy > last + 1e-6 * first) {
      return fmt::format(
          "A free decay from {} {} of {} gains energy at {:.3g} s: the damping "
          "drives the vehicle.",
          kLetGoAt,
          VelocityUnit(dof),
          Name(dof),
          stamps.velocity[k]);
    }
    last = energy;
  }
  if (last < 0.5 * first) return "";
  return fmt::format("A free decay from {} {} of {} keeps {:.0f} % of its energy after {:.3g} s.",
                     kLetGoAt,
                     VelocityUnit(dof),
                     Name(dof),
                     100.0 * last / first,
                     duration);
}

// Weight and buoyancy as they move the vehicle: without an offset, that of the thrust.
CoupledModel WithoutOffset(CoupledModel model) {
  model.offset.setZero();
  return model;
}

// What is wrong with the motion from rest that weight and buoyancy alone drive; empty: nothing.
std::string ProblemWithSink(const CoupledModel& model, double duration) {
  CoupledStamps stamps;
  stamps.velocity = {duration};
  CoupledOutputs outputs;
  if (RunCoupled(model, {}, {}, stamps, &outputs)) return "";
  return fmt::format(
      "A free sink from rest, under the net buoyancy of {:.4g} N, diverges: at that speed the "
      "damping drives the vehicle.",
      model.net_buoyancy);
}

// Roll and pitch rest where K sin(angle) + o = 0.
void AddProblemsWithTrim(const CoupledModel& model, std::vector<std::string>* problems) {
  for (const Dof dof : {Dof::kRoll, Dof::kPitch}) {
    const double righting = dof == Dof::kRoll ? model.righting_roll : model.righting_pitch;
    const double offset = std::abs(model.offset[Index(dof)]);
    if (righting == 0.0 || righting > offset) continue;
    problems->push_back(
        righting < 0.0
            ? fmt::format("The righting moment of {} is {:.4g} N m, expected above 0: at rest the "
                          "vehicle turns over.",
                          Name(dof),
                          righting)
            : fmt::format("The offset of {} is {:.4g} N m, above its righting moment of {:.4g} N "
                          "m: at rest the vehicle turns over.",
                          Name(dof),
                          offset,
                          righting));
  }
}

// The model with damping, inertia and Coriolis forces alone.
CoupledModel WithoutRestoring(CoupledModel model) {
  model.offset.setZero();
  model.net_buoyancy = model.righting_roll = model.righting_pitch = 0.0;
  return model;
}

}  // namespace

std::vector<std::string> CheckExport(const CoupledModel& model) {
  const double smallest = SmallestEigenvalue(model);
  if (!(smallest > 0.0)) {
    return {
        fmt::format("The inertia M has an eigenvalue of {:.4g}, expected all above 0.", smallest)};
  }
  std::vector<std::string> problems;
  if (model.coriolis) {
    const double work = LargestWorkOfCoriolis(model);
    if (!(work < 1e-12)) {
      problems.push_back(
          fmt::format("The Coriolis forces do work: nu' C nu is {:.2g} of its parts.", work));
    }
  }
  const double slowest = SlowestTimeConstant(model);
  if (!std::isfinite(slowest)) {
    problems.push_back("A DOF has no damping: nothing ends its motion.");
    return problems;
  }
  const CoupledModel free = WithoutRestoring(model);
  for (const Dof dof : model.dofs) {
    std::string problem = ProblemWithDecay(free, dof, kTimeConstants * slowest);
    if (!problem.empty()) problems.push_back(std::move(problem));
  }
  if (model.net_buoyancy != 0.0) {
    std::string problem = ProblemWithSink(WithoutOffset(model), 2.0 * kTimeConstants * slowest);
    if (!problem.empty()) problems.push_back(std::move(problem));
  }
  AddProblemsWithTrim(model, &problems);
  return problems;
}

std::vector<std::string> NamesOfExportChecks(const CoupledModel& model) {
  std::vector<std::string> names = {"the inertia"};
  if (model.coriolis) names.push_back("the Coriolis forces");
  names.push_back("a free decay");
  if (model.net_buoyancy != 0.0) names.push_back("a free sink");
  if (model.righting_roll != 0.0 || model.righting_pitch != 0.0) {
    names.push_back("the trim at rest");
  }
  return names;
}

}  // namespace fathom
