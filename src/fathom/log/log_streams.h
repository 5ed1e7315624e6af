// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/csv/csv_table.h"

#include <string>

namespace fathom {

// The streams of a log folder, each with the columns and rules of its own. `name` stands for
// the file in messages. They throw InputError, naming file, line and column.

// Some of tau_surge ... tau_yaw, or all of thruster_1 ... thruster_n, but not both; beside either
// or alone, fin_<name> and shaft_<name>.
CsvTable ParseCommand(const std::string& name, const std::string& text);

// Some of u v w p q r.
CsvTable ParseVelocity(const std::string& name, const std::string& text);

// x y z, z alone or none of them, and qx qy qz qw or none of them, but something; quaternions of
// length 1 within 1e-3.
CsvTable ParsePose(const std::string& name, const std::string& text);

// tag_id u0 v0 u1 v1 u2 v2 u3 v3; stamps may repeat, ids are whole numbers from 0 on.
CsvTable ParseDetections(const std::string& name, const std::string& text);

}  // namespace fathom
