// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/film_refinement.h"
#include "fathom/report/page.h"

namespace fathom {

// A page on a usable refinement: free runs of the joint model and of that of the PnP poses against
// what was measured, every number of both, the matrices. Its origin is left open.
Page FilmPage(const FilmRefinement& refinement);

}  // namespace fathom
