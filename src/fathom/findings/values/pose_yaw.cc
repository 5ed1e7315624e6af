// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/pose_yaw.h"

#include "fathom/signal/filters/unwrap.h"

#include <cmath>
#include <cstddef>

namespace fathom {

std::optional<std::vector<double>> UnwrappedYawOf(const Stream& pose) {
  const auto *x = pose.Find("qx"), *y = pose.Find("qy"), *z = pose.Find("qz"), *w = pose.Find("qw");
  if (x == nullptr || y == nullptr || z == nullptr || w == nullptr) return std::nullopt;
  std::vector<double> yaw;
  for (std::size_t i = 0; i < x->size(); ++i) {
    yaw.push_back(std::atan2(2.0 * ((*w)[i] * (*z)[i] + (*x)[i] * (*y)[i]),
                             1.0 - 2.0 * ((*y)[i] * (*y)[i] + (*z)[i] * (*z)[i])));
  }
  return Unwrap(yaw);
}

}  // namespace fathom
