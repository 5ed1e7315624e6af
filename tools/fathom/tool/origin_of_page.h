// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/report/page_origin.h"

#include <vector>

namespace fathom {

// The running tool, its command line, now (or the seconds since 1970 in SOURCE_DATE_EPOCH, so that
// the same run writes the same bytes), and these logs as they were read: from which stamp to
// which, and their fingerprints.
PageOrigin OriginOfPage(const std::vector<Log>& logs);

}  // namespace fathom
