// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/physical_barrier.h"

#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr double kBarrier = 0.05;          // mu
constexpr double kLeastStartOfLag = 0.02;  // [s]

using Kind = FreeEntry::Kind;

bool IsDiagonal(const FreeEntry& entry) { return entry.row == entry.column; }

// The DOFs whose diagonal of a matrix is free: the part that the bound is on.
std::vector<int> RowsOf(std::span<const FreeEntry> entries, Kind kind) {
  std::vector<int> rows;
  for (const FreeEntry& entry : entries) {
    if (entry.kind == kind && IsDiagonal(entry)) rows.push_back(Index(entry.row));
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

Eigen::MatrixXd Part(const Matrix6& matrix, const std::vector<int>& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd part(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      part(i, j) =
          0.5 * (matrix(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]) +
                 matrix(rows[static_cast<std::size_t>(j)], rows[static_cast<std::size_t>(i)]));
    }
  }
  return part;
}

// One -mu log det X, X a part of a matrix that some entries make up.
void AddLogDet(const Eigen::MatrixXd& x,
               const std::vector<int>& rows,
               Kind kind,
               std::span<const FreeEntry> entries,
               PhysicalBarrier* barrier) {
  if (rows.empty()) return;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(x);
  if (cholesky.info() != Eigen::Success || !(x.diagonal().minCoeff() > 0.0)) {
    barrier->cost = std::numeric_limits<double>::infinity();
    return;
  }
  const auto n = static_cast<Eigen::Index>(rows.size());
  const Eigen::MatrixXd lower = cholesky.matrixL();
  barrier->cost -= 2.0 * kBarrier * lower.diagonal().array().log().sum();
  const Eigen::MatrixXd inverse = cholesky.solve(Eigen::MatrixXd::Identity(n, n));
  // X^-1 E_k of each entry.
  std::vector<std::pair<Eigen::Index, Eigen::MatrixXd>> turned;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const FreeEntry& entry = entries[k];
    if (entry.kind != kind) continue;
    const auto i = std::find(rows.begin(), rows.end(), Index(entry.row));
    const auto j = std::find(rows.begin(), rows.end(), Index(entry.column));
    if (i == rows.end() || j == rows.end()) continue;
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(n, n);
    // An entry off the diagonal of the inertia stands there twice, of the damping once.
    const double share = kind == Kind::kInertia || IsDiagonal(entry) ? 1.0 : 0.5;
    unit(i - rows.begin(), j - rows.begin()) = share;
    unit(j - rows.begin(), i - rows.begin()) = share;
    turned.emplace_back(static_cast<Eigen::Index>(k), inverse * unit);
  }
  for (const auto& [k, a] : turned) {
    barrier->gradient[k] -= kBarrier * a.trace();
    for (const auto& [l, b] : turned) barrier->hessian(k, l) += kBarrier * (a * b).trace();
  }
}

// -mu log of each number that is above 0 in every model.
void AddPositive(const CoupledModel& model,
                 std::span<const FreeEntry> entries,
                 PhysicalBarrier* barrier) {
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (!IsPositive(entries[k])) continue;
    const double value = ValueIn(model, entries[k]);
    if (!(value > 0.0)) {
      barrier->cost = std::numeric_limits<double>::infinity();
      return;
    }
    const auto at = static_cast<Eigen::Index>(k);
    barrier->cost -= kBarrier * std::log(value / kLeastStartOfLag);
    barrier->gradient[at] -= kBarrier / value;
    barrier->hessian(at, at) += kBarrier / (value * value);
  }
}

}  // namespace

Matrix6 KnownInertia(const RigidBody& body) {
  if (const auto rigid = RigidInertia(body)) return *rigid;
  Matrix6 known = Matrix6::Zero();
  if (body.mass) known.diagonal().head<3>().setConstant(*body.mass);
  return known;
}

PhysicalBarrier BarrierAt(const CoupledModel& model,
                          std::span<const FreeEntry> entries,
                          const RigidBody& body) {
  const auto size = static_cast<Eigen::Index>(entries.size());
  PhysicalBarrier barrier = {0.0, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
  const std::vector<int> inertia = RowsOf(entries, Kind::kInertia);
  AddLogDet(Part(model.inertia - KnownInertia(body), inertia),
            inertia,
            Kind::kInertia,
            entries,
            &barrier);
  const std::vector<int> damping = RowsOf(entries, Kind::kLinearDamping);
  AddLogDet(Part(model.linear_damping, damping), damping, Kind::kLinearDamping, entries, &barrier);
  for (const int row : RowsOf(entries, Kind::kQuadraticDamping)) {
    AddLogDet(
        Part(model.quadratic_damping, {row}), {row}, Kind::kQuadraticDamping, entries, &barrier);
  }
  AddPositive(model, entries, &barrier);
  return barrier;
}

CoupledModel MovedInside(CoupledModel model,
                         std::span<const FreeEntry> entries,
                         const RigidBody& body,
                         const Vector6& least_linear,
                         const Vector6& least_quadratic,
                         const Vector6& least_inertia) {
  const Matrix6 known = KnownInertia(body);
  for (const FreeEntry& entry : entries) {
    if (IsLag(entry)) {
      SetValue(entry, std::max(ValueIn(model, entry), kLeastStartOfLag), &model);
    }
    if (IsLag(entry) || IsEffect(entry)) continue;
    if (!IsDiagonal(entry)) continue;
    const auto i = Index(entry.row);
    double value = ValueIn(model, entry);
    if (entry.kind == Kind::kInertia) {
      value = std::max({value, 1.1 * known(i, i), least_inertia[i]});
    } else if (entry.kind == Kind::kLinearDamping) {
      value = std::max(value, least_linear[i]);
    } else if (entry.kind == Kind::kQuadraticDamping) {
      value = std::max(value, least_quadratic[i]);
    } else {
      continue;
    }
    SetValue(entry, value, &model);
  }
  // Couplings shrink until the bounds hold. Those of the inertia towards the body's own.
  for (int tries = 0; tries < 40 && !std::isfinite(BarrierAt(model, entries, body).cost); ++tries) {
    for (const FreeEntry& entry : entries) {
      if (IsDiagonal(entry)) continue;
      if (entry.kind != Kind::kInertia && entry.kind != Kind::kLinearDamping) continue;
      const double towards =
          entry.kind == Kind::kInertia ? known(Index(entry.row), Index(entry.column)) : 0.0;
      SetValue(entry, towards + 0.7 * (ValueIn(model, entry) - towards), &model);
    }
  }
  return model;
}

}  // namespace fathom
