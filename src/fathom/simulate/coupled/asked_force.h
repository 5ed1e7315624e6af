// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <cstddef>

namespace fathom {

// What wrench and thrusters are asked for at a row of a command [N], [N m]: by a model's gains, its
// effects of the thrust, and its angle. Without what is late.
Vector6 AskedForce(const CoupledCommand& command, std::size_t row, const CoupledModel& model);

// Its derivative by a thrust gain or an effect of the thrust; 0 by any other entry.
Vector6 AskedForceBy(const FreeEntry& entry,
                     const CoupledCommand& command,
                     std::size_t row,
                     const CoupledModel& model);

}  // namespace fathom
