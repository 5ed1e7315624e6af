// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/extended_model.h"

#include <string>

namespace fathom {

// Another explanation of the log that a verdict is about.
struct RivalModel {
  std::string label;  // "thrust_dead_zone"
  ExtendedModel model;
};

}  // namespace fathom
