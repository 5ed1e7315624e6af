// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/correction.h"
#include "fathom/log/log.h"

#include <string>
#include <vector>

namespace fathom {

// Puts columns of the log's velocities right as log->corrections say, which log.yaml holds, and
// `asked`, which stands in for log.yaml's of the same column, and for which `asked_by` asks. A late
// column is read off so much later, between its samples on a straight line; rows for which that
// tells nothing are left out. Tells each in a remark, and leaves in log->corrections what was done.
// `log_yaml` and `velocity` are the names of the files, and `asked_by` as "--correct", in messages.
//
// Throws InputError if a column is not there, or no row is left.
void CorrectVelocity(const std::string& log_yaml,
                     const std::string& velocity,
                     const std::vector<Correction>& asked,
                     const std::string& asked_by,
                     Log* log);

}  // namespace fathom
