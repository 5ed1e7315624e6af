// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <string>
#include <vector>

namespace fathom {

// What Gazebo's elements do not hold of a model, and where it belongs instead, a sentence each:
// docs/export.md. `body`: mass and centre of mass are known.
std::vector<std::string> GazeboRemarks(const ExportModel& model, const RigidBody& body);

}  // namespace fathom
