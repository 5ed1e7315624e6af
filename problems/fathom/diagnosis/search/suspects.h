// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/diagnosis/search/suspect.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// The effects that these segments can show at all, each with every partner it may have. With
// several logs, what belongs to a run is a suspect in each of those that are trained on.
std::vector<Suspect> SuspectsFor(const MeasuredSegments& segments,
                                 Dof dof,
                                 std::span<const Effect* const> effects);

// "thruster_lag", "velocity_coupling(sway)", "buoyancy_step(dive_2)".
std::string LabelOf(const Suspect& suspect);

// Whether all of some, by their indices in `suspects`, act on the poses alone; false of none.
bool ActOnPosesAlone(const std::vector<int>& indices, const std::vector<Suspect>& suspects);

// Place of a suspect's effect in a model; -1 if it is not there.
int PlaceIn(const ExtendedModel& model, const Suspect& suspect);

// "time_offset with thrust_curve": the labels of some, by their indices in `suspects`.
std::string LabelsOf(const std::vector<int>& indices, const std::vector<Suspect>& suspects);

}  // namespace fathom
