// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "generic_models.h"

#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <vector>

namespace fathom {
namespace {

void Set(FittedCoupledModel* fitted, const FreeEntry& entry, double value) {
  fitted->entries.push_back(entry);
  SetValue(entry, value, &fitted->model);
}

// Standard deviations of 0.1, but the last not known.
void SetCovariance(FittedCoupledModel* fitted) {
  const auto size = static_cast<Eigen::Index>(fitted->entries.size());
  fitted->covariance = 0.01 * Eigen::MatrixXd::Identity(size, size);
  fitted->covariance(size - 1, size - 1) = std::numeric_limits<double>::quiet_NaN();
}

void SetDiagonal(FittedCoupledModel* fitted,
                 const std::vector<double>& inertia,
                 const std::vector<double>& linear,
                 const std::vector<double>& quadratic) {
  for (std::size_t i = 0; i < fitted->model.dofs.size(); ++i) {
    const Dof dof = fitted->model.dofs[i];
    Set(fitted, InertiaEntry(dof, dof), inertia[i]);
    Set(fitted, LinearDampingEntry(dof, dof), linear[i]);
    Set(fitted, QuadraticDampingEntry(dof, dof), quadratic[i]);
  }
}

}  // namespace

FittedCoupledModel GenericRov() {
  FittedCoupledModel fitted;
  fitted.model.dofs = {kAllDofs.begin(), kAllDofs.end()};
  fitted.model.coriolis = true;
  fitted.force_unit = "N";
  fitted.provenance = {{"log", "tank_07"}, {"version", "0.1.0"}};
  SetDiagonal(&fitted,
              {40.0, 61.0, 72.0, 2.1, 3.2, 4.3},
              {5.0, 8.0, 9.0, 0.5, 0.6, 0.8},
              {30.0, 60.0, 80.0, 1.0, 1.2, 1.5});
  Set(&fitted, InertiaEntry(Dof::kSway, Dof::kYaw), 2.2);
  Set(&fitted, InertiaEntry(Dof::kSurge, Dof::kPitch), -1.5);
  Set(&fitted, InertiaEntry(Dof::kSway, Dof::kRoll), 1.3);
  Set(&fitted, LinearDampingEntry(Dof::kSway, Dof::kYaw), 0.7);
  Set(&fitted, LinearDampingEntry(Dof::kYaw, Dof::kSway), -0.4);
  Set(&fitted, LinearDampingEntry(Dof::kPitch, Dof::kSurge), 0.3);
  Set(&fitted, QuadraticDampingEntry(Dof::kSway, Dof::kRoll), 0.2);
  for (const Dof dof : {Dof::kSurge, Dof::kSway, Dof::kRoll, Dof::kPitch, Dof::kYaw}) {
    Set(&fitted, OffsetEntry(dof), 0.03 * (1 + Index(dof)) * (Index(dof) % 2 == 0 ? 1.0 : -1.0));
  }
  Set(&fitted, NetBuoyancyEntry(), 2.0);
  Set(&fitted, RightingMomentEntry(Dof::kRoll), 6.0);
  Set(&fitted, RightingMomentEntry(Dof::kPitch), 7.0);
  Set(&fitted, ThrustGainEntry("port"), 0.8);
  SetCovariance(&fitted);
  return fitted;
}

FittedCoupledModel GenericBoat() {
  FittedCoupledModel fitted;
  fitted.model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  fitted.model.coriolis = true;
  fitted.force_unit = "N";
  fitted.provenance = {{"log", "lake_3"}};
  SetDiagonal(&fitted, {55.0, 81.0, 7.3}, {12.0, 23.0, 3.1}, {41.0, 95.0, 4.7});
  Set(&fitted, InertiaEntry(Dof::kSway, Dof::kYaw), -4.1);
  Set(&fitted, LinearDampingEntry(Dof::kSway, Dof::kYaw), 1.9);
  Set(&fitted, OffsetEntry(Dof::kYaw), -0.17);
  SetCovariance(&fitted);
  return fitted;
}

FittedCoupledModel GenericBoatWithEffects() {
  FittedCoupledModel fitted = GenericBoat();
  for (const auto& [name, value] : {std::pair{"coulomb_friction.surge", 1.5},
                                    std::pair{"coulomb_friction.yaw", 0.2},
                                    std::pair{"cubic_damping.sway", 33.0},
                                    std::pair{"damping_asymmetry.surge", 0.6},
                                    std::pair{"thrust_dead_zone.sway", 2.5},
                                    std::pair{"thrust_asymmetry.sway", 0.3}}) {
    Set(&fitted, ParseFreeEntry(name), value);
  }
  SetCovariance(&fitted);
  return fitted;
}

FittedModel GenericOneDof(Dof dof) {
  FittedModel fitted;
  fitted.dof = dof;
  fitted.force_unit = IsAngular(dof) ? "N m" : "N";
  const double i = 1.0 + Index(dof);
  fitted.model = {20.0 + 3.0 * i, 11.0 + i, 4.0 + 0.5 * i, -0.3 * i};
  fitted.covariance = 0.04 * Eigen::Matrix4d::Identity();
  fitted.provenance = {{"log", "pool"}, {"family", "output_error"}};
  return fitted;
}

ExportTarget GenericTarget() {
  ExportTarget target = {"rov", "a test"};
  target.vehicle.emplace();
  target.vehicle->size = Eigen::Vector3d(0.7, 0.5, 0.3);
  RigidBody& body = target.vehicle->body;
  body.mass = 30.0;
  body.inertia_tensor.emplace();
  *body.inertia_tensor << 1.1, 0.05, -0.07, 0.05, 1.7, 0.02, -0.07, 0.02, 2.3;
  body.centre_of_mass = Eigen::Vector3d(0.03, -0.02, 0.04);
  return target;
}

}  // namespace fathom
