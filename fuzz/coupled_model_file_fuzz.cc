// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a model file of several DOFs; what is read must be written and read again to the
// same.

#include "fathom/base/input_error.h"
#include "fathom/vehicle/files/coupled_model_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  fathom::IsCoupledModel(text);
  try {
    const auto model = fathom::ParseCoupledModel("m.json", text);
    const auto again = fathom::ParseCoupledModel("m.json", fathom::FormatCoupledModel(model));
    if (again.entries != model.entries) std::abort();
    if (again.model.dofs != model.model.dofs) std::abort();
    if (again.model.inertia != model.model.inertia) std::abort();
    if (again.model.linear_damping != model.model.linear_damping) std::abort();
    if (again.model.quadratic_damping != model.model.quadratic_damping) std::abort();
    if (again.model.lift != model.model.lift) std::abort();
    if (again.model.offset != model.model.offset) std::abort();
    if (again.model.thrust_angle != model.model.thrust_angle) std::abort();
    if (again.model.time_offset != model.model.time_offset) std::abort();
    if (again.model.thruster_lag != model.model.thruster_lag) std::abort();
    if (again.model.thrust_gain != model.model.thrust_gain) std::abort();
    if (again.model.fin_force != model.model.fin_force) std::abort();
    if (again.model.fin_race != model.model.fin_race) std::abort();
    if (again.model.fin_neutral != model.model.fin_neutral) std::abort();
    if (again.model.fin_stuck != model.model.fin_stuck) std::abort();
    if (again.model.fin_lag != model.model.fin_lag) std::abort();
    if (again.model.fin_rate_limit != model.model.fin_rate_limit) std::abort();
    if (again.model.fin_stall != model.model.fin_stall) std::abort();
  } catch (const fathom::InputError&) {
  }
  return 0;
}
