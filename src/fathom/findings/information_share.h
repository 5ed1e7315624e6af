// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

namespace fathom {

// What several logs of one vehicle know together, and how much of it comes from each.
//
//   C = (sum_i C_i^-1)^-1,   s_ip = [C C_i^-1 C]_pp / C_pp                 docs/findings.md (8)
//
//   C_i   covariance of the parameters by log i alone
//   s_ip  share of log i in parameter p: the shares of all logs add up to 1
//
// The estimate of all logs is the mean of theirs, weighted by C C_i^-1; C C_i^-1 C is what the
// noise of log i adds to its covariance. It holds where the logs have independent noise and one
// vehicle.
struct SharedInformation {
  Eigen::MatrixXd covariance;  // C
  Eigen::MatrixXd share;       // [log, parameter]
};

// Nothing where a covariance cannot be inverted or is not finite, or where there is none.
std::optional<SharedInformation> ShareInformation(std::span<const Eigen::MatrixXd> covariances);

}  // namespace fathom
