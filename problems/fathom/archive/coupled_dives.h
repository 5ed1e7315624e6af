// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/jobs/coupled_dive_job.h"
#include "fathom/archive/log_batch.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace fathom {

// A vehicle, DOFs, and the dive's place in the order of all dives.
using CoupledFitKey = std::tuple<std::string, std::string, int>;

// The coupled fits of dives that may be made: of each vehicle all of whose logs are done, and of
// the DOFs of which five dives or more have a coupled model of a log, the least that a change is
// looked for in.
//
// All dives of a vehicle free the same numbers, as else they could not be compared: those of a
// diagonal model, and beyond it those that the logs of two dives or more show, as a change has two
// dives on either side; and the current that a log shows, which is of it alone. C(nu) acts where it
// does in more than half of the logs. Logs without a usable coupled model, and those that the fits
// of single DOFs leave out, take no part.
std::map<CoupledFitKey, CoupledDiveTask> CoupledDiveTasks(
    const std::vector<BatchLog>& logs, const std::map<std::string, int>& place_of_dive);

}  // namespace fathom
