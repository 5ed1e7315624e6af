// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/records.h"
#include "fathom/diagnosis/screen.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// The effects that these records can show at all, each with every partner it may have.
std::vector<Suspect> SuspectsFor(const Records& records,
                                 Dof dof,
                                 std::span<const Effect* const> effects);

// "thruster_lag", "velocity_coupling(sway)".
std::string LabelOf(const Suspect& suspect);

// "time_offset with thrust_curve": the labels of some, by their indices in `suspects`.
std::string LabelsOf(const std::vector<int>& indices, const std::vector<Suspect>& suspects);

}  // namespace fathom
