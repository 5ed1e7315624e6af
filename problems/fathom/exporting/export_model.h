// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/fitted_model.h"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace fathom {

// One number of a model as a comment beside it tells it.
struct ExportNumber {
  FreeEntry entry;
  double value = 0.0;
  double std = std::numeric_limits<double>::quiet_NaN();  // NaN: not known
  bool is_identified = true;                              // false: it was held
  std::string unit;                                       // "kg m^2/s"
  std::string log;                                        // that it was identified from, in short
};

// An effect along one DOF: a lag of the thrusters, a dead zone.
struct ExportEffectValue {
  std::string name;
  double value = 0.0;
  double std = std::numeric_limits<double>::quiet_NaN();  // NaN: not known
  std::string unit;
};
struct ExportEffect {
  std::string name;   // "thruster_lag"
  std::string label;  // LabelOf()
  Dof dof = Dof::kSurge;
  std::vector<ExportEffectValue> values;
  std::string log;
};

// A model as all formats take it: docs/export.md.
struct ExportModel {
  CoupledModel model;
  std::vector<ExportNumber> numbers;  // all that act: identified ones, and held ones other than 0
  std::vector<ExportEffect> effects;

  // True of models of one DOF each, joined on the diagonal: what couples the DOFs is not known.
  bool is_joined = false;

  std::string force_unit = "N";      // or the log's command_unit: numbers are then only ratios
  std::vector<std::string> sources;  // a line for each file that it was read from
  std::vector<std::string> caveats;  // what was said when it was fitted
  std::vector<std::string> notes;    // what no format can hold, a sentence each
};

bool IsModelled(const ExportModel& model, Dof dof);

ExportModel ExportModelOf(const FittedCoupledModel& fitted, const std::string& file);

// Several models of one DOF as one, its matrices diagonal. The buoyancy of heave becomes the net
// buoyancy, that of other DOFs an offset. `files`: their names, in the same order. Throws
// InputError if two are of the same DOF, or their commands have different units.
ExportModel ExportModelOf(const std::vector<FittedModel>& models,
                          const std::vector<std::string>& files);

// Reads one model of several DOFs, or models and verdicts of one DOF each. Throws InputError,
// naming the file, for what is neither, and if a model of several DOFs is not the only one.
ExportModel ReadExportModel(const std::vector<std::filesystem::path>& paths);

}  // namespace fathom
