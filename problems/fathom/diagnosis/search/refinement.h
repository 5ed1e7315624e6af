// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/hypothesis_book.h"

#include <span>
#include <vector>

namespace fathom {

// A hypothesis with what it gains by its fit.
Hypothesis Weighed(const SearchTask& task, const Hypothesis& baseline, Hypothesis hypothesis);

// The hypothesis of these suspects, from a rough fit of them: its noise is learned along, from the
// baseline's or that of `base`, a hypothesis near it. One that gains less under its first noise
// than its share of `most_gain`, SearchOptions::hope, is left at that. WithSettled() judges whether
// the model means something.
Hypothesis BegunFrom(const SearchTask& task,
                     const Hypothesis& baseline,
                     const Hypothesis& base,
                     std::vector<int> suspects,
                     const StructureFit& rough,
                     double most_gain);

// The book with those of BegunFrom() whose model means something: one that can be simulated, does
// not leave the inertia open or far beyond the baseline's, and has no tone where the command has
// its own. Those that may lead, by SearchOptions::contends of the greatest gain among them and
// `most_gain`, and gain something over what stands without one of their suspects, have their noise
// learned from nothing first.
HypothesisBook WithSettled(const SearchTask& task,
                           std::vector<Hypothesis> begun,
                           double most_gain,
                           HypothesisBook book);

// The book with `base`, one of its hypotheses, and one suspect more, each in turn, from where each
// of the screens about `base` shows it best. What was tried before, only where it now shows
// elsewhere.
HypothesisBook Refined(const SearchTask& task,
                       const Screens& screens,
                       const Hypothesis& base,
                       std::span<const int> suspects,
                       HypothesisBook book);

}  // namespace fathom
