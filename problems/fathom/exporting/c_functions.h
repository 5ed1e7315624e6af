// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"

#include <string>
#include <vector>

namespace fathom {

// The functions of the C header, as C text; `name` begins their names.

// "BOAT_INERTIA" of "boat.inertia".
std::string InCapitals(std::string text);

bool HasNumber(const ExportModel& model, const FreeEntry& entry);

// "BOAT_INERTIA_SWAY_YAW", of the gain of a thruster "BOAT_THRUST_GAIN_2" by its place among the
// numbers of its kind.
std::string MacroOf(const ExportModel& model, const FreeEntry& entry, const std::string& name);

// "BOAT_SURGE_THRUST_DEAD_ZONE_WIDTH", of number k of an effect; and a line for each number.
std::string MacroOfEffect(const ExportEffect& effect, std::size_t k, const std::string& name);
std::string MacrosOfEffect(const ExportEffect& effect, const std::string& name);

// What a row of a matrix has for each column: {column, macro}.
struct MacroTerm {
  Dof column = Dof::kSurge;
  std::string macro;
};
std::vector<MacroTerm> TermsOf(const ExportModel& model,
                               FreeEntry::Kind kind,
                               Dof row,
                               const std::string& name);

std::string CInertia(const ExportModel& model, const std::string& name);
std::string CCoriolis(const ExportModel& model, const std::string& name);
std::string CDamping(const ExportModel& model, const std::string& name);
std::string CRestoring(const ExportModel& model, const std::string& name);
std::string COffset(const ExportModel& model, const std::string& name);

}  // namespace fathom
