// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/film_refinement.h"

#include <string>

namespace fathom {

// What a usable refinement gives, for a terminal: every number with its interval beside that of the
// fit of the PnP poses, free runs of both, what the corners and the DOFs do.
std::string FormatFilmRefinement(const FilmRefinement& refinement);

// One sentence with both errors and their ratio.
std::string FormatPathErrors(const PathErrors& errors);

}  // namespace fathom
