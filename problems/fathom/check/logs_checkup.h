// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/checked_logs.h"
#include "fathom/findings/information_share.h"
#include "fathom/identification/run_agreement.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fathom {

// What to hold out of one log.
struct LogHeldOut {
  std::size_t log_index = 0;
  TimeInterval time;
};

// What several logs say of one DOF.
struct DofOfLogs {
  Dof dof = Dof::kSurge;
  std::vector<std::size_t> log_indices;  // of those that give a model alone, two or more

  // Its logs are those of `log_indices`. Nothing where a log leaves a parameter without an
  // interval.
  std::optional<SharedInformation> information;

  RunAgreement agreement;  // whether its logs say the same

  std::vector<LogHeldOut> held_out;  // proposed; empty where a log.yaml holds something out
};

// Each DOF of which two logs or more give a model, and which of them carry the information. The
// split that is proposed holds out whole logs, where two are left, up to a half of the excited
// time: those without which the ellipsoid of the parameters grows least, until a quarter is held
// out. Otherwise it holds out what ExcitationOf() proposes for each.
//
// Throws InputError if their commands have different units.
std::vector<DofOfLogs> CompareLogs(std::span<const CheckedLog> logs);

// The checkup of a log for one DOF that it gives a model of; null if there is none.
const DofCheckup* FindDof(const LogCheckup& checkup, Dof dof);

}  // namespace fathom
