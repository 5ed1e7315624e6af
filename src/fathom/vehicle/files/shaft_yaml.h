// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/files/yaml_file.h"
#include "fathom/vehicle/shaft.h"
#include "fathom/vehicle/thruster.h"

#include <vector>

namespace fathom {

// The `shafts` of a vehicle file, docs/file_formats.md. Throws InputError, naming file, line and
// key, for a curve that does not begin at rest or does not push there, shares of 1 and above, and a
// name that another shaft or one of the thrusters has.
std::vector<Shaft> ReadShafts(const YamlMap& file, const std::vector<Thruster>& thrusters);

}  // namespace fathom
