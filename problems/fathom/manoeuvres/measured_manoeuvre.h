// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/manoeuvres/measured_gear.h"
#include "fathom/simulate/coupled/manoeuvre.h"
#include "fathom/simulate/coupled/manoeuvre_run.h"

#include <optional>

namespace fathom {

// The manoeuvre in what a log measured, if it holds this one: a zigzag of this angle within half a
// degree, of this heading and first to this side; a turning circle whose rudder goes from straight
// to this angle and stays within a degree of it for a quarter turn at least. Other manoeuvres are
// not looked for. Time, place and heading count from the rudder's first move.
//
// `logged`: LoggedTrack(), `gear`: GearOf() it.
std::optional<ManoeuvreTrack> MeasuredManoeuvre(const ManoeuvreTrack& logged,
                                                const std::optional<MeasuredGear>& gear,
                                                const Manoeuvre& manoeuvre);

}  // namespace fathom
