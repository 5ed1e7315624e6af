// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

namespace ceres {
class LossFunction;
}

namespace fathom {

// ClippedLoss beyond `limit`, for Ceres.
std::unique_ptr<ceres::LossFunction> MakeClippedLoss(double limit);

}  // namespace fathom
