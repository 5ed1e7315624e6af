// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/hypothesis_book.h"

#include <memory>

namespace fathom {

// The book with those pairs that only together explain much, by the linear screen about the
// baseline under the noise of the best single suspect.
HypothesisBook WithPairs(const SearchTask& task,
                         const std::shared_ptr<const FitAndTrials>& baseline,
                         HypothesisBook book);

}  // namespace fathom
