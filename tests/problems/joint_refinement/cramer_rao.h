// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/parameters.h"

#include "camera_experiment.h"

namespace fathom {

// Standard deviations of the parameters, in the order of kParameterInfo, that no unbiased estimate
// from these corners can go below: from the joint problem's own Jacobian at the truth, with the
// corner noise and the wander as they are, and with the start, the held coordinates' means and all
// poses unknown. Only for the wander kinds kFiltered (a second-order process itself) and kNone.
ParameterVector CramerRaoStd(const CameraExperiment& experiment, const SyntheticCameraRun& run);

}  // namespace fathom
