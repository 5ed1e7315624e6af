// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/hypothesis_book.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// The hypothesis of these suspects, from a rough fit of them: its noise is learned along. Nothing
// if no model that means something comes of it: one that can be simulated, does not leave the
// inertia open, and has no tone where the command has its own. One that gains less under its first
// noise than its share of `most_gain`, SearchOptions::hope, is left at that.
std::optional<Hypothesis> HypothesisFrom(const SearchTask& task,
                                         const Hypothesis& baseline,
                                         const std::vector<int>& suspects,
                                         const StructureFit& rough,
                                         double most_gain);

// The book with `base`, one of its hypotheses, and one suspect more, each in turn, from where each
// of the screens about `base` shows it best. What was tried before, only where it now shows
// elsewhere.
HypothesisBook Refined(const SearchTask& task,
                       const Screens& screens,
                       const Hypothesis& base,
                       std::span<const int> suspects,
                       HypothesisBook book);

}  // namespace fathom
