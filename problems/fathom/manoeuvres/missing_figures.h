// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/manoeuvre.h"
#include "fathom/simulate/coupled/manoeuvre_figures.h"
#include "fathom/simulate/coupled/manoeuvre_run.h"

#include <string>
#include <vector>

namespace fathom {

// Why figures of FiguresOf(manoeuvre, track) have no value: how far the run came, and what they
// need. A sentence, or none where all have one; none of a spiral and a pull-out.
std::vector<std::string> MissingFigureSentences(const Manoeuvre& manoeuvre,
                                                const ManoeuvreTrack& track,
                                                const std::vector<ManoeuvreFigure>& figures);

}  // namespace fathom
