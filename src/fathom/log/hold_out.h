// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"
#include "fathom/log/log.h"

#include <span>
#include <vector>

namespace fathom {

// Holds `asked` out of a log in place of what its log.yaml says; nothing asked: what that says.
// Remarks on intervals that hold no sample of the motion.
//
// Where the log's stamps count from some epoch (beyond 1e6 s) and an interval lies before that, it
// counts from the first sample of the motion: 240 to 300 is the fifth minute of any log.
void HoldOut(const std::vector<TimeInterval>& asked, Log* log);

// Throws InputError for an interval that HoldOut() held out of each of these logs and that lies
// outside all of them.
void RequireHeldOutInside(const std::vector<TimeInterval>& asked, std::span<const Log> logs);

}  // namespace fathom
