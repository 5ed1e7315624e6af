// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/identification/identification.h"
#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// A joint refinement as one result among those of Identify(), scored as they are: by free runs over
// `scored`.
Identification IdentificationOf(const JointSummary& joint, const Signals& scored);

// `joint`, or, where that has no usable model or a worse score than the best of `guesses` by 2 %,
// the model of that guess in its place; message and a caveat then say so. The score is the NMAE on
// the held-out data; where nothing is held out, that on all data if a sensor of its own is the
// yardstick
// (`scored_against`), which no row was fitted to.
Identification OrBestGuess(Identification joint,
                           std::span<const Identification> guesses,
                           Source scored_against);

// The joint refinement of the corners in these logs' detections.csv, along the DOF of `scored`.
// What was left out or decided on the way is added to `remarks`. Poses that the logs hold are not
// read. Its guesses, as in OrBestGuess(), are the other families on the poses of the same corners.
//
// A fit that does not work does not throw: see the result. Throws InputError if a log lacks
// detections or their calibration, as PrepareMarkerLogs() does, or for broken options.
Identification IdentifyJointly(std::vector<Log> logs,
                               const Signals& scored,
                               const IdentificationOptions& options,
                               std::vector<std::string>* remarks);

}  // namespace fathom
