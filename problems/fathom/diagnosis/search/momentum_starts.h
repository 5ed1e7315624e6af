// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/hypothesis_book.h"
#include "fathom/diagnosis/search/search_task.h"

namespace fathom {

// The book with the baseline and one suspect more, of the vehicle and not of a run, refitted from
// where MomentumBalance puts both: the best of them. Where the baseline is far from the truth,
// screens about it mislead.
HypothesisBook WithSinglesByMomentum(const SearchTask& task, HypothesisBook book);

}  // namespace fathom
