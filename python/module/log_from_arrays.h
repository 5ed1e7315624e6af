// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "module/arguments.h"
#include "module/opened_log.h"
#include <pybind11/pybind11.h>

namespace fathom {

// What a log says beside its streams; the keys of log.yaml (docs/file_formats.md).
struct ArraysInfo {
  std::string name;
  std::vector<std::string> dofs;
  Pairs held_out;
  std::optional<double> mass;
  std::string vehicle;  // a path of a vehicle file; may be empty
  std::string command_unit;
  std::string thruster_unit;
};

// A log of streams that Python holds: dicts from a column's name to its array, "t" among them, or
// None. They become what the reader of log folders reads, so that a log from arrays is held to the
// same rules and is the same to the last bit. Throws InputError as that reader does.
OpenedLog LogFromArrays(const pybind11::object& command,
                        const pybind11::object& velocity,
                        const pybind11::object& pose,
                        const ArraysInfo& info);

}  // namespace fathom
