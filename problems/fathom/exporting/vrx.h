// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

namespace fathom {

// A model with VRX's plugin vrx::SimpleHydrodynamics, for boats: added mass and dampings positive,
// all diagonal. The plugin's own defaults are not 0, so that every element is written.
// docs/export.md.
//
// `problems`: those of SplitInertiaOf(). Throws InputError as it and RemarksOn() do.
ExportedFile VrxModel(const ExportModel& model, const ExportTarget& target);

}  // namespace fathom
