// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/files/yaml_file.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/rigid_body.h"
#include "fathom/vehicle/fin.h"
#include "fathom/vehicle/shaft.h"
#include "fathom/vehicle/thruster.h"

#include <vector>

namespace fathom {

// The `coupled_model` of a vehicle file, docs/file_formats.md: how the vehicle moves in several
// DOFs, docs/coupled.md (1). The rest is what else the file tells: the rigid body that added mass
// is added to, the thrusters, fins and shafts that numbers belong to.
//
// Throws InputError, naming file, line and key, for a matrix of another shape, an inertia that is
// not symmetric or not positive definite, damping that would give energy, and a thruster, fin
// or shaft that the file does not name.
CoupledModel ReadCoupledYaml(const YamlMap& map,
                             const RigidBody& body,
                             const std::vector<Thruster>& thrusters,
                             const std::vector<Fin>& fins,
                             const std::vector<Shaft>& shafts = {});

}  // namespace fathom
