// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/gazebo_remarks.h"

#include "fathom/base/names_of_dofs.h"
#include "fathom/exporting/comment_text.h"

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kGravity = 9.8;        // [m/s^2], of Gazebo's worlds
constexpr double kWaterDensity = 1000;  // [kg/m^3], of Gazebo's buoyancy system

bool HasNetBuoyancy(const ExportModel& model) {
  for (const ExportNumber& number : model.numbers) {
    if (number.entry == NetBuoyancyEntry()) return true;
  }
  return false;
}

std::string VolumeRemark(const ExportModel& model, const RigidBody& body) {
  const double buoyancy = model.model.net_buoyancy;
  return fmt::format(
      "Weight and buoyancy come from Gazebo's gravity and gz::sim::systems::Buoyancy, which needs "
      "a collision. {} give it a volume of {:.6g} m^3 (at {} kg/m^3 and {} m/s^2).",
      HasNetBuoyancy(model) ? fmt::format("For the net buoyancy of {:.4g} N", buoyancy)
                            : "The net buoyancy is not known: to let the vehicle hover",
      (*body.mass + buoyancy / kGravity) / kWaterDensity,
      kWaterDensity,
      kGravity);
}

// Roll and pitch right themselves by W z_g - B z_b, z down.
void AddRightingRemarks(const ExportModel& model,
                        const RigidBody& body,
                        std::vector<std::string>* remarks) {
  const double weight = *body.mass * kGravity;
  const double buoyancy = weight + model.model.net_buoyancy;
  for (const ExportNumber& number : model.numbers) {
    if (number.entry.kind != FreeEntry::Kind::kRightingMoment) continue;
    const double down = (weight * body.centre_of_mass->z() - number.value) / buoyancy;
    remarks->push_back(
        fmt::format("{} of {:.4g} N m has no element: put the centre of that collision at z = "
                    "{:.4g} m, up.",
                    NameOf(number.entry),
                    number.value,
                    down == 0.0 ? 0.0 : -down));
  }
}

// Inertia that couples a modelled DOF with one that was only measured.
void AddPartnerRemarks(const ExportModel& model, std::vector<std::string>* remarks) {
  for (const ExportNumber& number : model.numbers) {
    if (number.entry.kind != FreeEntry::Kind::kInertia || IsModelled(model, number.entry.column))
      continue;
    remarks->push_back(fmt::format("{} of {:.4g} {} is left out: {} is not modelled.",
                                   NameOf(number.entry),
                                   number.value,
                                   number.unit,
                                   Name(number.entry.column)));
  }
}

}  // namespace

std::vector<std::string> GazeboRemarks(const ExportModel& model, const RigidBody& body) {
  std::vector<std::string> remarks = model.left_out;
  remarks.push_back(VolumeRemark(model, body));
  AddRightingRemarks(model, body, &remarks);
  for (const ExportNumber& number : model.numbers) {
    if (number.entry.kind == FreeEntry::Kind::kOffset && number.value != 0.0) {
      remarks.push_back(
          fmt::format("{} of {:.4g} {} is left out: no element holds a constant "
                      "force. Subtract it from the thrust.",
                      NameOf(number.entry),
                      number.value,
                      number.unit));
    }
    if (number.entry.kind == FreeEntry::Kind::kThrustGain) {
      remarks.push_back(
          fmt::format("{} of {:.4g} is left out: multiply the thrust coefficient of "
                      "that thruster's plugin by it.",
                      NameOf(number.entry),
                      number.value));
    }
  }
  AddPartnerRemarks(model, &remarks);
  if (!model.model.coriolis) {
    remarks.push_back(
        "The model has no Coriolis forces, but Gazebo adds those of the inertia. They act where "
        "several degrees of freedom move at once.");
  }
  std::vector<Dof> others;
  for (const Dof dof : kAllDofs) {
    if (!IsModelled(model, dof)) others.push_back(dof);
  }
  if (!others.empty()) {
    remarks.push_back(
        fmt::format("Not modelled: {}. Their added mass and damping are not known and stand as 0.",
                    NamesOf(others)));
  }
  return remarks;
}

}  // namespace fathom
