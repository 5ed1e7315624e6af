// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/vehicle/fitted_model.h"

#include <string>
#include <vector>

namespace fathom {

// Throws InputError if a model was fitted to one of these logs, which would count twice then. Says
// on stderr where the model's file, `file`, does not tell what it was fitted to.
void RequireOtherLogs(const std::vector<Log>& logs,
                      const std::vector<std::string>& log_fingerprints,
                      const std::string& file);

// Throws InputError if the model of `file` misses all of the log's motion: then the log says
// nothing of its parameters.
void RequireSameVehicle(const Log& log, const FittedModel& model, const std::string& file);

}  // namespace fathom
