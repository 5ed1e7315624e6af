// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <string>

namespace fathom {

// A log in Python, with how it was opened, which a model's provenance tells.
struct OpenedLog {
  Log log;
  std::string place;          // the path as it was given; the name of a log from arrays
  std::string velocity;       // the file that stands for velocity.csv; may be empty
  std::string held_out;       // "240:300", as --held_out takes it; empty: what the log says
  bool is_of_arrays = false;  // no folder holds it
};

}  // namespace fathom
