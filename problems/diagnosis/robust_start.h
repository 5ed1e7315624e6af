// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/records.h"
#include "fathom/vehicle/extended_model.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// Where the fits start: output error's robust answer, and the states the records start from.
struct RobustStart {
  ExtendedModel model;
  std::vector<InitialState> initial;
};

// The baseline by output error (problems/output_error), from a guess of its own; nothing if it does
// not converge to a physical model.
std::optional<RobustStart> FindRobustStart(std::span<const Record> records);

}  // namespace fathom
