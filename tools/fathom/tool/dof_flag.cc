// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/dof_flag.h"

#include "fathom/base/input_error.h"
#include "fathom/tool/flag_values.h"

#include <string>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(dof,
              "",
              "surge, sway, heave, roll, pitch or yaw. Default: the only DOF of the log, or that "
              "of the model; a stream has none.");

namespace fathom {

std::optional<Dof> DofFromFlag() {
  if (FLAGS_dof.empty()) return std::nullopt;
  if (FLAGS_dof.find(',') != std::string::npos) {
    throw InputError(
        fmt::format("--dof: is '{}', expected one DOF. Several as one motion: --dofs={}.",
                    FLAGS_dof,
                    FLAGS_dof));
  }
  return ParseFlag("dof", FLAGS_dof, ParseDof);
}

}  // namespace fathom
