// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/hypothesis_book.h"

#include <memory>

namespace fathom {

// The book with its best hypothesis tried with each cause left out and with each replaced, until
// none of these is better.
HypothesisBook Challenged(const SearchTask& task,
                          const std::shared_ptr<const FitAndTrials>& baseline,
                          HypothesisBook book);

}  // namespace fathom
