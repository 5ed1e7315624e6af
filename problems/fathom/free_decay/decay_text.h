// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/log_decay.h"
#include "fathom/report/table.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// A number that a decay tells, with its standard deviation.
struct DecayQuantity {
  std::string name;  // "linear_damping / inertia", or "linear_damping" where the inertia is known
  std::string unit;  // "1/s"
  double value = 0.0;
  double std = 0.0;
  double lower_bound = 0.0;
};

// The ratios, then where the inertia is known the parameters.
std::vector<DecayQuantity> QuantitiesOf(const LogDecay& decay);

// "linear_damping / inertia 0.2 1/s (95 % ...), ...".
std::string QuantitiesText(const LogDecay& decay);

// What can be known without a command, and what this decay tells of it, or why it tells nothing.
std::string DecaySentence(const LogDecay& decay);

// The quantities, a row each.
Table QuantityTable(const LogDecay& decay);

// What is to be said beside that table, a line each.
std::vector<std::string> DecayComments(const LogDecay& decay);

// The mean error of the simulated speed by the mean speed, docs/models.md (8); NaN where
// displacements were fitted, or nothing.
double NmaeOf(const LogDecay& decay);

// What a terminal shows of it.
std::string FormatDecay(const LogDecay& decay);

// The file format fathom-decay-1; docs/free_decay.md. `log`: as --log names it.
std::string FormatDecayJson(const LogDecay& decay, const std::string& log);

// The model of a usable decay with a known inertia; nothing without one, or with a stiffness, which
// a model file does not hold. Its inertia is taken as exact.
std::optional<FittedModel> ModelOf(const LogDecay& decay);

}  // namespace fathom
