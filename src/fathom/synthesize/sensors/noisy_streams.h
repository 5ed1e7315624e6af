// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/synthesize/experiment/experiment.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Where a vehicle is: world_from_body.
struct ShownPlace {
  Eigen::Vector3d position;  // [m]
  Eigen::Vector4d attitude;  // unit quaternion x, y, z, w
};

// What is shown at the k-th sample of a sensor, t seconds after the start. Asked in their order.
using VelocityShown = std::function<std::array<double, 6>(std::size_t k, double t)>;
using PlaceShown = std::function<ShownPlace(std::size_t k, double t)>;

// When the experiment's sensors measure, since the start [s]: lost samples too.
std::vector<double> VelocityTimes(const Experiment& experiment, std::uint64_t seed);
std::vector<double> PoseTimes(const Experiment& experiment, std::uint64_t seed);

// velocity.csv, in log time: what is shown along `dofs` with the noise, outliers, drop-outs and
// resolution of the experiment's velocity sensor, which it has. Drop-outs are remarked on in `log`.
Stream NoisyVelocities(const std::vector<Dof>& dofs,
                       const VelocityShown& shown,
                       const Experiment& experiment,
                       std::uint64_t seed,
                       Log& log);

// pose.csv likewise, of the experiment's pose sensor, stamped `delay` [s] later.
Stream NoisyPoses(const PlaceShown& shown,
                  double delay,
                  const Experiment& experiment,
                  std::uint64_t seed,
                  Log& log);

}  // namespace fathom
