// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_format.h"
#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

#include <string>
#include <vector>

namespace fathom {

// What of a model a format may hold.
enum class ExportFeature {
  kInertia,
  kInertiaCouplings,
  kCoriolis,
  kLinearDamping,     // along the axes
  kQuadraticDamping,  // along the axes
  kDampingOfTurns,
  kLinearCouplings,
  kQuadraticCouplings,
  kLift,
  kNetBuoyancy,
  kRightingMoment,
  kTrim,    // offset of roll and pitch
  kOffset,  // of the others
  kThrustGain,
  kFins,
  kThrustAngle,
  kLag,
  kThrustSize,      // along a DOF: a dead zone, a saturation, an asymmetry of thrusters
  kThrusterEffect,  // a dead zone or an asymmetry of each thruster
  kDragEffects,
  kDelay,
  kOtherEffects,
  kOtherUnit,
  kOtherDofs,
  kVehicle,
};

// How a format holds it.
struct HeldFeature {
  enum class How { kYes, kNote, kLeftOut, kRefused };
  How how = How::kYes;
  const char* shown = "yes";  // in the table of docs/export.md

  // Of what is left out: why, and where it belongs, after "is left out: ".
  const char* instead = "";
};

ExportFeature FeatureOf(const FreeEntry& entry);
ExportFeature FeatureOf(const ExportEffect& effect);
HeldFeature Held(ExportFormat format, ExportFeature feature);

// The table format x feature in Markdown, as docs/export.md and `fathom_export --table` show it.
std::string FeatureTable();

// What a format does not hold of a model, a sentence each, by that table. Throws InputError where
// the format refuses what the model has.
std::vector<std::string> RemarksOn(ExportFormat format,
                                   const ExportModel& model,
                                   const ExportTarget& target);

}  // namespace fathom
