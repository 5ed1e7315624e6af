// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"
#include "fathom/report/table.h"

#include <cstddef>
#include <limits>

namespace fathom {

// The causes: what each is, how large with its 95 % interval, and how sure it is.
Table CauseTable(const Diagnosis& diagnosis);

// The parameters of the baseline alone and with the causes in, and the causes' own, with their
// standard deviations; where there are no causes, of the baseline.
Table BeforeAndAfterTable(const Diagnosis& diagnosis);

// The first `most` candidates, best first, with why each was kept or dropped.
Table CandidateTable(const Diagnosis& diagnosis,
                     std::size_t most = std::numeric_limits<std::size_t>::max());

// What these logs leave room for of every effect that is not named (95 %).
Table LimitTable(const Diagnosis& diagnosis);

}  // namespace fathom
