// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/identification/family.h"
#include "fathom/identification/identification.h"
#include "fathom/identification/log_offset.h"
#include "fathom/identification/run_agreement.h"
#include "fathom/log/log.h"
#include "fathom/output_error/offset_sharing.h"
#include "fathom/signal/signals.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

struct LogIdentificationOptions {
  std::optional<Dof> dof = {};        // absent: the only one that each log names
  std::optional<Source> source = {};  // absent: the best that each log has, for kJoint kCamera
  Family family = Family::kOutputError;
  // Of output error alone: whether the logs share one offset or have one each. It takes the place
  // of identification.output_error.offsets.
  OffsetScope offset = OffsetScope::kShared;
  IdentificationOptions identification = {};

  // Every broken rule, a sentence each, by the name of the field; empty if there is none.
  std::vector<std::string> Problems() const;
};

// One family's model of one DOF, and what is to be said of the data behind it.
struct LogIdentification {
  Signals signals;  // of all logs
  std::vector<Finding> findings;
  std::vector<std::string> remarks;  // of the joint refinement, a sentence each
  Identification result;

  // Of several logs, each by the same family alone. The intervals of the result are widened by what
  // the runs differ by more than by noise, and its caveats say so. Absent for kJoint.
  std::optional<RunAgreement> agreement;

  // By OffsetScope::kPerLog, else empty: of the logs that have training data. The model has their
  // mean, by which its figures are.
  std::vector<LogOffset> offsets;
};

// Fits one family to several logs together, each with an initial state of its own, and scores it on
// the same signals. kJoint takes the logs' detections and their calibration, and needs their poses
// for the score: TrackDetections() makes them.
//
// A fit that does not work does not throw: see the result. Throws InputError for options that break
// their rules, and if the logs lack what is asked for, differ in DOF, source or command unit, or
// hold out all of their data.
LogIdentification IdentifyFromLogs(std::vector<Log> logs, const LogIdentificationOptions& options);

}  // namespace fathom
