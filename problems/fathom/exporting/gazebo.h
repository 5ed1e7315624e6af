// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

namespace fathom {

// A model of SDF 1.10 with one link, for Gazebo from Garden (gz-sim 7) on: mass, inertia and
// <fluid_added_mass> in its <inertial>, and the plugin gz::sim::systems::Hydrodynamics with the
// dampings, at most 0 where they take energy. Never xDotU and its like: the plugin changed their
// sign between versions. Gazebo's body is x forward, y port, z up. docs/export.md.
//
// `problems`: those of SplitInertiaOf() and HydrostaticsOf(). Throws InputError as SplitInertiaOf()
// and RemarksOn() do.
ExportedFile GazeboModel(const ExportModel& model, const ExportTarget& target);

}  // namespace fathom
