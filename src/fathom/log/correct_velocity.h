// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/correction.h"
#include "fathom/log/log.h"

#include <string>
#include <vector>

namespace fathom {

// Multiplies columns of the log's velocities by log->corrections, which log.yaml holds, and by
// `asked`, which --correct holds and which stands in for log.yaml's of the same column. Tells each
// in a remark, and leaves in log->corrections what was done. `log_yaml` and `velocity` are the
// names of the files, as in messages.
//
// Throws InputError if a column is not there.
void CorrectVelocity(const std::string& log_yaml,
                     const std::string& velocity,
                     const std::vector<Correction>& asked,
                     Log* log);

}  // namespace fathom
