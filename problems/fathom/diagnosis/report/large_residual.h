// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <optional>

namespace fathom {

// The NMAE of the model to be used, of training or held-out data, whichever is larger, where it is
// over a fifth of the motion. `consistent` then says that the rest looks like noise, not that it is
// small. Nothing where it is smaller, or not known.
std::optional<double> LargeResidual(const Diagnosis& diagnosis);

}  // namespace fathom
