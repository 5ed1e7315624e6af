// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/logs_checkup.h"

#include "fathom/base/input_error.h"
#include "fathom/log/proposed_held_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/LU>
#include <fmt/format.h>

namespace fathom {
namespace {

// One log's part in the search for a split.
struct Part {
  std::size_t log_index = 0;
  double excited = 0.0;  // [s]
  TimeInterval span;     // of its motion
  Eigen::MatrixXd covariance;
};

Part PartOf(std::span<const CheckedLog> logs, std::size_t log_index, Dof dof) {
  const DofCheckup& checkup = *FindDof(logs[log_index].checkup, dof);
  const auto& segments = checkup.signals->train;
  // Up to, not including, its end: the last stamp is held out too.
  const double end =
      std::nextafter(segments.back().time.back(), std::numeric_limits<double>::infinity());
  return {log_index,
          checkup.excitation.excited,
          {segments.front().time.front(), end},
          checkup.model->fitted.covariance};
}

// The logarithm of the ellipsoid's squared volume, of all parts but one; infinite where they leave
// a parameter open.
double VolumeWithout(const std::vector<Part>& parts, std::size_t without) {
  std::vector<Eigen::MatrixXd> covariances;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != without) covariances.push_back(parts[i].covariance);
  }
  const auto shared = ShareInformation(covariances);
  if (!shared) return std::numeric_limits<double>::infinity();
  // Of correlations and deviations apart: the units differ by far.
  const Eigen::VectorXd std = shared->covariance.diagonal().cwiseSqrt();
  const Eigen::VectorXd scale = std.cwiseInverse();
  const Eigen::MatrixXd correlation = scale.asDiagonal() * shared->covariance * scale.asDiagonal();
  return std::log(correlation.determinant()) + 2.0 * std.array().log().sum();
}

// Whole logs; empty where too few are left.
std::vector<LogHeldOut> WholeLogs(std::vector<Part> parts) {
  constexpr double kMostShare = 0.5;
  constexpr std::size_t kFewestLeft = 2;
  double all = 0.0, held = 0.0;
  for (const Part& part : parts) all += part.excited;
  std::vector<LogHeldOut> held_out;
  while (parts.size() > kFewestLeft && held < kHeldOutShare * all) {
    std::size_t best = parts.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool may_go = parts[i].excited > 0.0 && held + parts[i].excited <= kMostShare * all;
      const double volume = may_go ? VolumeWithout(parts, i) : least;
      if (volume < least) {
        best = i;
        least = volume;
      }
    }
    if (best == parts.size()) break;
    held += parts[best].excited;
    held_out.push_back({parts[best].log_index, parts[best].span});
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(best));
  }
  std::ranges::sort(held_out, {}, &LogHeldOut::log_index);
  return held_out;
}

std::vector<LogHeldOut> ProposedSplit(std::span<const CheckedLog> logs, const DofOfLogs& of_dof) {
  std::vector<Part> parts;
  for (const std::size_t i : of_dof.log_indices) {
    if (!logs[i].checkup.log.held_out.empty()) return {};
    parts.push_back(PartOf(logs, i, of_dof.dof));
  }
  std::vector<LogHeldOut> held_out = WholeLogs(std::move(parts));
  if (!held_out.empty()) return held_out;
  for (const std::size_t i : of_dof.log_indices) {
    const auto& own = FindDof(logs[i].checkup, of_dof.dof)->excitation.held_out;
    if (own) held_out.push_back({i, *own});
  }
  return held_out;
}

void RequireOneUnit(std::span<const CheckedLog> logs, const DofOfLogs& of_dof) {
  const auto unit_of = [&](std::size_t i) {
    return FindDof(logs[i].checkup, of_dof.dof)->model->fitted.force_unit;
  };
  const std::size_t first = of_dof.log_indices.front();
  for (const std::size_t i : of_dof.log_indices) {
    if (unit_of(i) == unit_of(first)) continue;
    throw InputError(fmt::format("--log: {} commands {} in {}, {} in {}, expected one unit.",
                                 logs[first].path,
                                 Name(of_dof.dof),
                                 unit_of(first),
                                 logs[i].path,
                                 unit_of(i)));
  }
}

}  // namespace

const DofCheckup* FindDof(const LogCheckup& checkup, Dof dof) {
  for (const DofCheckup& one : checkup.dofs) {
    if (one.dof == dof && one.model && one.model->is_usable) return &one;
  }
  return nullptr;
}

std::vector<DofOfLogs> CompareLogs(std::span<const CheckedLog> logs) {
  std::vector<DofOfLogs> dofs;
  for (const Dof dof : kAllDofs) {
    DofOfLogs of_dof;
    of_dof.dof = dof;
    std::vector<RunEstimate> runs;
    std::vector<Eigen::MatrixXd> covariances;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      const DofCheckup* const checkup = FindDof(logs[i].checkup, dof);
      if (checkup == nullptr) continue;
      of_dof.log_indices.push_back(i);
      const FittedModel& fitted = checkup->model->fitted;
      covariances.emplace_back(fitted.covariance);
      runs.push_back(
          {logs[i].path, true, ToVector(fitted.model), fitted.covariance.diagonal().cwiseSqrt()});
    }
    if (of_dof.log_indices.size() < 2) continue;
    RequireOneUnit(logs, of_dof);
    of_dof.information = ShareInformation(covariances);
    of_dof.agreement = AgreementOf(std::move(runs));
    of_dof.held_out = ProposedSplit(logs, of_dof);
    dofs.push_back(std::move(of_dof));
  }
  return dofs;
}

}  // namespace fathom
