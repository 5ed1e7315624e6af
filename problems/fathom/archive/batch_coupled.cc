// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/batch_coupled.h"

#include "fathom/archive/jobs/log_jobs.h"
#include "fathom/base/input_error.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/files/coupled_model_file.h"

namespace fathom {

std::optional<BatchCoupled> CoupledInVerdict(const std::string& verdict) {
  try {
    const FittedCoupledModel fitted = ParseCoupledModel("verdict", verdict);
    BatchCoupled coupled = {.dofs = JoinedNames(fitted.model.dofs),
                            .coriolis = fitted.model.coriolis,
                            .beyond_diagonal = {}};
    for (const FreeEntry& entry : fitted.entries) {
      const bool is_diagonal = !IsOfActuator(entry) && entry.row == entry.column;
      if (!is_diagonal) coupled.beyond_diagonal.push_back(NameOf(entry));
    }
    return coupled;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace fathom
