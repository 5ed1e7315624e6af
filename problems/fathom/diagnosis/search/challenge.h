// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/hypothesis_book.h"

#include <memory>
#include <vector>

namespace fathom {

// What was tried, and which of it stands for the data best so far.
struct Standing {
  HypothesisBook book;
  int best = 0;
};

// Tries the best hypothesis with each cause left out and with each replaced, until none of these is
// better.
Standing Challenged(const SearchTask& task,
                    const std::shared_ptr<const FitAndTrials>& baseline,
                    Standing standing);

}  // namespace fathom
