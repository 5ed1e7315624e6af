// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/autoregression.h"

#include <Eigen/Core>

namespace fathom {

// How much of a recursion comes after its last samples: with `last` the order() last rows, the
// oldest first, and nothing new after them, the sum of the squares of all rows to come is
// last' E last. In closed form, however long the echo. The noise needs an order of 1 at least.
Eigen::MatrixXd EchoOf(const Autoregression& noise);

}  // namespace fathom
