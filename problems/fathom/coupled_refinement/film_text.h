// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/film_refinement.h"
#include "fathom/report/table.h"

#include <string>

namespace fathom {

// What a usable refinement gives, for a terminal: every number with its interval beside that of the
// fit of the PnP poses, free runs of both, what the corners and the DOFs do.
std::string FormatFilmRefinement(const FilmRefinement& refinement);

// The numbers of both fits, and the NMAE of free runs of both.
Table FilmEntryTable(const FilmRefinement& refinement);
Table FilmFigureTable(const FilmRefinement& refinement);

// What the free runs are measured against, in words.
std::string FilmJudge(const FilmRefinement& refinement);

// How the corners scatter, and which DOFs leave the simulated motion.
std::string FilmCornerSentence(const FilmRefinement& refinement);

// One sentence with both errors and their ratio.
std::string FormatPathErrors(const PathErrors& errors);

}  // namespace fathom
