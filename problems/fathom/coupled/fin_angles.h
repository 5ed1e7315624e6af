// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <cstddef>
#include <vector>

namespace fathom {

// The angles that a command gives its fins by the limited rates of a model. A lag is no part of it.
class FinAngles {
 public:
  // The command must outlive this.
  FinAngles(const CoupledCommand& command, const CoupledModel& model);

  // Of a fin, by its place in the command, `since` s after a row began to hold [rad].
  double At(std::size_t fin, std::size_t row, double since) const;

 private:
  const CoupledCommand& command_;
  std::vector<double> rates_;               // by fin [rad/s]; infinite: at once
  std::vector<std::vector<double>> begun_;  // by fin and row: where it begins; empty: at once
};

}  // namespace fathom
