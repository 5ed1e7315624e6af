// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/manoeuvres/drawn_figures.h"
#include "fathom/simulate/coupled/manoeuvre.h"
#include "fathom/simulate/coupled/manoeuvre_figures.h"

#include <string>
#include <vector>

namespace fathom {

// Whether the vehicle holds a straight track: with the rudder midships the yaw rates that are left
// after turns to either side differ by less than 2 % of what the turns themselves differ by. Of the
// figures of a spiral or a pull-out; NaN leaves it open and is taken for no.
bool HoldsStraightTrack(const std::vector<ManoeuvreFigure>& figures);

// It in words, with the share of the drawn models that say the same. None of other manoeuvres.
std::vector<std::string> StraightTrackSentences(const Manoeuvre& manoeuvre,
                                                const std::vector<ManoeuvreFigure>& figures,
                                                const std::vector<ManoeuvreFigures>& drawn);

}  // namespace fathom
