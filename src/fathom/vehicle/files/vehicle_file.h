// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/rigid_body.h"
#include "fathom/vehicle/fin.h"
#include "fathom/vehicle/shaft.h"
#include "fathom/vehicle/thrust_table.h"
#include "fathom/vehicle/thruster.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What a vehicle file tells about a vehicle; docs/file_formats.md.
struct Vehicle {
  std::string name;
  std::optional<double> mass;           // dry [kg], above 0
  std::optional<Eigen::Vector3d> size;  // length, width, height [m], above 0
  // Mass plus added mass, by Index(Dof) [kg] or [kg m^2], above 0; what free decays are scaled by.
  std::array<std::optional<double>, 6> inertia;
  RigidBody body;                          // its mass is the one above
  std::vector<Thruster> thrusters;         // may be empty: commands are then forces
  std::vector<ThrustTable> thrust_tables;  // that thrusters name
  std::vector<Fin> fins;                   // fins and rudders, each name once
  std::vector<Shaft> shafts;               // names that no thruster has, each once

  // Its motion where that is known, by Index(Dof); what fathom_synthesize makes logs from.
  std::array<std::optional<UncoupledModel<double>>, 6> models;

  // The same of several DOFs that act on each other, in place of `models`.
  std::optional<CoupledModel> coupled;
};

// The table that a thruster of the vehicle names, among the vehicle's own; null if it names none.
const ThrustTable* TableOf(const Thruster& thruster, const Vehicle& vehicle);

// Throws InputError, naming file, line and key, for whatever breaks the format.
Vehicle ReadVehicleFile(const std::filesystem::path& path);

// The same from memory; `name` stands for the file in messages.
Vehicle ParseVehicleFile(const std::string& name, const std::string& text);

}  // namespace fathom
