// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/dof_flag.h"

#include "fathom/tool/flag_values.h"

#include <gflags/gflags.h>

DEFINE_string(dof,
              "",
              "surge, sway, heave, roll, pitch or yaw. Default: the only DOF of the log, or that "
              "of the model; a stream has none.");

namespace fathom {

std::optional<Dof> DofFromFlag() {
  if (FLAGS_dof.empty()) return std::nullopt;
  return ParseFlag("dof", FLAGS_dof, ParseDof);
}

}  // namespace fathom
