// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

namespace fathom {

// A model for Gazebo classic with the plugin of underwater objects of uuv_simulator and Plankton,
// type fossen. The plugin works in x forward, y starboard, z down: added mass is positive, dampings
// are below 0 where they take energy, quadratic damping is diagonal. Buoyancy, righting moments and
// their trim are a volume and its centre, x forward, y port, z up. docs/export.md.
//
// `problems`: those of SplitInertiaOf() and HydrostaticsOf(). Throws InputError as SplitInertiaOf()
// and RemarksOn() do.
ExportedFile UuvModel(const ExportModel& model, const ExportTarget& target);

}  // namespace fathom
