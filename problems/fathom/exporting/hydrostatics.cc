// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/hydrostatics.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

bool HasNumber(const ExportModel& model, const FreeEntry& entry) {
  for (const ExportNumber& number : model.numbers) {
    if (number.entry == entry) return true;
  }
  return false;
}

// The mean of those that are known; 0 where none is.
double SharedRightingMoment(const ExportModel& model, std::vector<std::string>* remarks) {
  const bool has_roll = HasNumber(model, RightingMomentEntry(Dof::kRoll));
  const bool has_pitch = HasNumber(model, RightingMomentEntry(Dof::kPitch));
  const double roll = model.model.righting_roll, pitch = model.model.righting_pitch;
  if (!has_roll && !has_pitch) {
    remarks->push_back(
        "No righting moment is known: the centre of buoyancy stands where there is none.");
    return 0.0;
  }
  if (!has_roll || !has_pitch) return has_roll ? roll : pitch;
  const double mean = 0.5 * (roll + pitch);
  if (roll != pitch) {
    remarks->push_back(
        fmt::format("One centre of buoyancy rights roll and pitch alike: by {:.4g} N m, instead of "
                    "{:.4g} N m in roll and {:.4g} N m in pitch.",
                    mean,
                    roll,
                    pitch));
  }
  return mean;
}

// From K sin(angle) + o = 0 to K' tan(angle') + o = 0, that of a body and its water.
void AddTrimProblem(
    Dof dof, double righting, double shared, double offset, std::vector<std::string>* problems) {
  if (!(righting > std::abs(offset))) return;  // nothing holds it level: CheckExport()
  const double of_model = std::asin(-offset / righting), of_file = std::atan2(-offset, shared);
  if (std::abs(of_model - of_file) <= kDegree) return;
  problems->push_back(fmt::format(
      "At rest the exported vehicle would have a {} of {:.3g} degrees, the model has {:.3g}: the "
      "righting moments of roll and pitch differ too much for one centre of buoyancy.",
      Name(dof),
      of_file / kDegree,
      of_model / kDegree));
}

}  // namespace

Hydrostatics HydrostaticsOf(const ExportModel& model, const RigidBody& body, double gravity) {
  Hydrostatics water;
  if (!HasNumber(model, NetBuoyancyEntry())) {
    water.remarks.push_back(
        "The net buoyancy is not known: the volume is that of a vehicle that hovers.");
  }
  const double righting = SharedRightingMoment(model, &water.remarks);
  const auto o_roll = model.model.offset[3], o_pitch = model.model.offset[4];
  AddTrimProblem(Dof::kRoll, model.model.righting_roll, righting, o_roll, &water.problems);
  AddTrimProblem(Dof::kPitch, model.model.righting_pitch, righting, o_pitch, &water.problems);

  const Eigen::Vector3d moment = *body.mass * gravity * *body.centre_of_mass;
  water.weight = *body.mass * gravity;
  water.buoyancy = water.weight + model.model.net_buoyancy;
  water.volume = water.buoyancy / (kWaterDensity * gravity);
  if (!(water.volume > 0.0)) {
    water.problems.push_back(
        fmt::format("The buoyancy would be {:.4g} N, expected above 0: the net buoyancy of {:.4g} "
                    "N is below the weight of {:.4g} N.",
                    water.buoyancy,
                    model.model.net_buoyancy,
                    water.weight));
    return water;
  }
  water.centre_of_buoyancy =
      (moment + Eigen::Vector3d(-o_pitch, o_roll, -righting)) / water.buoyancy;
  return water;
}

}  // namespace fathom
