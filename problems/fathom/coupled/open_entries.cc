// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/open_entries.h"

#include "fathom/base/interval95.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

constexpr double kSingular = 1e-11;  // of the scaled normal equations
constexpr double kOnBound = 0.3;     // within so many standard deviations of its bound

}  // namespace

std::vector<FreeEntry> UndeterminedIn(const Eigen::MatrixXd& normal,
                                      const std::vector<FreeEntry>& entries) {
  const Eigen::VectorXd diagonal = normal.diagonal();
  std::vector<FreeEntry> found;
  const double largest = diagonal.size() > 0 ? diagonal.maxCoeff() : 0.0;
  for (Eigen::Index k = 0; k < diagonal.size(); ++k) {
    if (!(diagonal[k] > 0.0) || !std::isfinite(largest))
      found.push_back(entries[static_cast<std::size_t>(k)]);
  }
  if (!found.empty() || diagonal.size() == 0) return found;
  const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
  const SymmetricEigen eigen = EigenOf(scale.asDiagonal() * normal * scale.asDiagonal());
  for (Eigen::Index i = 0; i < diagonal.size(); ++i) {
    if (eigen.values[i] > kSingular) continue;
    for (Eigen::Index k = 0; k < diagonal.size(); ++k) {
      const FreeEntry& entry = entries[static_cast<std::size_t>(k)];
      if (std::abs(eigen.vectors(k, i)) > 0.2 &&
          std::find(found.begin(), found.end(), entry) == found.end()) {
        found.push_back(entry);
      }
    }
  }
  return found;
}

std::vector<FreeEntry> InertiasThatMayBe0(const CoupledSummary& summary) {
  std::vector<FreeEntry> found;
  for (std::size_t k = 0; k < summary.entries.size(); ++k) {
    const FreeEntry& entry = summary.entries[k];
    if (!IsOwnInertia(entry)) continue;
    if (std::ranges::count(summary.priors, entry, &EntryPrior::entry) > 0) continue;
    const auto at = static_cast<Eigen::Index>(k);
    if (!(ValueIn(summary.model, entry) > kStdsOf95 * std::sqrt(summary.covariance(at, at)))) {
      found.push_back(entry);
    }
  }
  return found;
}

std::vector<FreeEntry> OpenBesideTheBestTold(const CoupledSummary& summary,
                                             const Eigen::MatrixXd& normal) {
  std::vector<FreeEntry> open = summary.undetermined;
  std::erase_if(open, [](const FreeEntry& entry) { return !IsOwnInertia(entry); });
  const auto trace = [&](const FreeEntry& entry) {
    const auto at = std::ranges::find(summary.entries, entry) - summary.entries.begin();
    const double value = ValueIn(summary.model, entry);
    return value * value * normal(at, at);
  };
  if (open.size() > 1) open.erase(std::ranges::max_element(open, {}, trace));
  return open;
}

std::vector<FreeEntry> OnBound(const CoupledSummary& summary, const RigidBody& body) {
  const Matrix6 known = KnownInertia(body);
  std::vector<FreeEntry> found;
  for (std::size_t k = 0; k < summary.entries.size(); ++k) {
    const FreeEntry& entry = summary.entries[k];
    using Kind = FreeEntry::Kind;
    const bool is_damping =
        entry.kind == Kind::kLinearDamping || entry.kind == Kind::kQuadraticDamping;
    if (!(is_damping || entry.kind == Kind::kInertia) || entry.row != entry.column) continue;
    const auto at = static_cast<Eigen::Index>(k);
    const double bound =
        entry.kind == Kind::kInertia ? known(Index(entry.row), Index(entry.row)) : 0.0;
    if (ValueIn(summary.model, entry) - bound < kOnBound * std::sqrt(summary.covariance(at, at))) {
      found.push_back(entry);
    }
  }
  return found;
}

}  // namespace fathom
