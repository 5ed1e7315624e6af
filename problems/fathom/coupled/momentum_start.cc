// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/momentum_start.h"

#include "fathom/coupled/command_forces.h"
#include "fathom/coupled/fin_angles.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/coriolis.h"
#include "fathom/vehicle/coupled/coupled_effects.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/coupled/turned_about_z.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kPiece = 1.0;               // [s]
constexpr std::size_t kFewestOfPiece = 6;    // samples
constexpr double kRidge = 1e-6;              // of a column's own squares
constexpr double kLeastDampingShare = 0.02;  // of the force over the speed
constexpr double kLeastInertiaShare = 0.05;  // of the impulse over the change of speed

constexpr double kNoForce = 1e-9;  // [N], [N m]

using Kind = FreeEntry::Kind;

// What an entry of 1 adds to the left side of (6), at a velocity and its change.
Vector6 RateOf(const FreeEntry& entry,
               const Vector6& nu,
               const Eigen::Vector3d& down,
               bool coriolis) {
  Vector6 force = Vector6::Zero();
  const auto i = Index(entry.row), j = Index(entry.column);
  switch (entry.kind) {
    case Kind::kInertia: {
      if (!coriolis) break;
      Vector6 momentum = Vector6::Zero();
      momentum[i] = nu[j];
      if (i != j) momentum[j] = nu[i];
      force = CoriolisForceOfMomentum(momentum, nu);
      break;
    }
    case Kind::kLinearDamping:
      force[i] = nu[j];
      break;
    case Kind::kQuadraticDamping:
      force[i] = std::abs(nu[j]) * nu[j];
      break;
    case Kind::kRightingMoment:
      force[i] = entry.row == Dof::kRoll ? down[1] : -down[0];
      break;
    case Kind::kNetBuoyancy:
      force.head<3>() = down;
      break;
    case Kind::kOffset:
      force[i] = 1.0;
      break;
    case Kind::kLift:
      force[i] = nu[0] * nu[j];
      break;
    case Kind::kEffect:
      if (!IsOfThrust(*entry.effect))
        force[i] = ResistanceOf(*entry.effect, 0.0, nu[i], 0.0).by_value;
      break;
    case Kind::kThrusterEffect:
    case Kind::kCurrent:
    case Kind::kRunOffset:
    case Kind::kThrustGain:
    case Kind::kThrustAngle:
    case Kind::kTimeOffset:
    case Kind::kThrusterLag:
    case Kind::kFinForce:
    case Kind::kFinRace:
    case Kind::kFinNeutral:
    case Kind::kFinStuck:
    case Kind::kFinLag:
    case Kind::kFinRateLimit:
    case Kind::kFinStall:
      break;
  }
  return force;
}

Vector6 KnownOr0(const Vector6& velocity) {
  return velocity.unaryExpr([](double v) { return std::isfinite(v) ? v : 0.0; });
}

// What the water's effects of a model resist with.
Vector6 EffectsAt(const Vector6& nu, const CoupledModel& model) {
  Vector6 force = Vector6::Zero();
  for (const Effect* effect : WaterEffects()) {
    const auto values = model.effects.find(std::string(effect->info().name));
    if (values == model.effects.end()) continue;
    for (Eigen::Index i = 0; i < 6; ++i) {
      const double quadratic = model.quadratic_damping(i, i);
      force[i] += ResistanceOf(*effect, values->second[i], nu[i], quadratic).force;
    }
  }
  return force;
}

// Rows of (6), a row for each modelled DOF and piece.
struct Balance {
  std::vector<Eigen::VectorXd> rows;
  std::vector<double> right;
  std::vector<int> dof;
};

void AddPieces(const CoupledData& log,
               const CoupledSegment& segment,
               const MotionStructure& structure,
               const CoupledModel& held,
               const FinAngles& angles,
               Balance* balance) {
  const auto num = static_cast<Eigen::Index>(structure.entries.size());
  const CoupledCommand& command = log.inputs.command;
  std::size_t begin = 0;
  while (begin + 1 < segment.time.size()) {
    std::size_t end = begin + 1;
    while (end + 1 < segment.time.size() &&
           (segment.time[end] - segment.time[begin] < kPiece || end - begin < kFewestOfPiece)) {
      ++end;
    }
    const CoupledState first = MeasuredState(segment, begin), last = MeasuredState(segment, end);
    Eigen::Matrix<double, 6, Eigen::Dynamic> left =
        Eigen::Matrix<double, 6, Eigen::Dynamic>::Zero(6, num);
    const double from = segment.time[begin], to = segment.time[end];
    const Vector6 impulse = ThrustImpulse(command, from, to, held);
    Vector6 right = impulse;
    const Vector6 change = last.nu - first.nu;
    right -= held.inertia * change;
    for (std::size_t i = begin; i < end; ++i) {
      const double dt = segment.time[i + 1] - segment.time[i];
      const Vector6 nu = 0.5 * (KnownOr0(segment.velocity[i]) + KnownOr0(segment.velocity[i + 1]));
      const Eigen::Quaterniond attitude(MeasuredState(segment, i).attitude);
      const Eigen::Vector3d down = attitude.conjugate() * Eigen::Vector3d::UnitZ();
      Vector6 known = held.linear_damping * nu +
                      held.quadratic_damping * nu.cwiseAbs().cwiseProduct(nu) + held.offset +
                      nu[0] * (held.lift * nu) -
                      FinForcesAt(command, angles, segment.time[i], nu, held);
      if (structure.coriolis) known += CoriolisForce(held.inertia, nu);
      known.head<3>() += held.net_buoyancy * down;
      known[3] += held.righting_roll * down[1];
      known[4] -= held.righting_pitch * down[0];
      known += EffectsAt(nu, held);
      known -= ShaftForcesAt(command, segment.time[i], nu, held);
      right -= dt * known;
      for (Eigen::Index k = 0; k < num; ++k) {
        const FreeEntry& entry = structure.entries[static_cast<std::size_t>(k)];
        left.col(k) += dt * RateOf(entry, nu, down, structure.coriolis);
        if (!IsOfActuator(entry)) continue;
        left.col(k) -= dt * (FinForcesBy(entry, command, angles, segment.time[i], nu, held) +
                             ShaftForcesBy(entry, command, segment.time[i], nu, held));
      }
    }
    for (Eigen::Index k = 0; k < num; ++k) {
      const FreeEntry& entry = structure.entries[static_cast<std::size_t>(k)];
      if (entry.kind == Kind::kInertia) {
        left(Index(entry.row), k) += change[Index(entry.column)];
        if (entry.row != entry.column) left(Index(entry.column), k) += change[Index(entry.row)];
      } else {
        left.col(k) -= ThrustImpulseBy(entry, command, from, to, held);
      }
      if (IsLateness(entry)) {
        left.col(k) -= FinForcesLater(entry, command, angles, from, KnownOr0(first.nu), held) -
                       FinForcesLater(entry, command, angles, to, KnownOr0(last.nu), held);
      }
    }
    for (const Dof dof : structure.dofs) {
      balance->rows.emplace_back(left.row(Index(dof)));
      balance->right.push_back(right[Index(dof)]);
      balance->dof.push_back(Index(dof));
    }
    begin = end;
  }
}

// For a DOF that nothing drives, the largest number of those of its kind, along an axis or about
// one, that something drives; of all where its kind has none.
void FillUndriven(const std::array<bool, 6>& is_driven, Vector6* values) {
  const Vector6 known = *values;
  for (Eigen::Index i = 0; i < 6; ++i) {
    if (is_driven[static_cast<std::size_t>(i)]) continue;
    double of_kind = 0.0, of_all = 0.0;
    for (Eigen::Index j = 0; j < 6; ++j) {
      if (!is_driven[static_cast<std::size_t>(j)]) continue;
      of_all = std::max(of_all, known[j]);
      if (i / 3 == j / 3) of_kind = std::max(of_kind, known[j]);
    }
    (*values)[i] = of_kind > 0.0 ? of_kind : std::max(of_all, known[i]);
  }
}

// The least squares of the rows, each DOF's by its own scatter. Numbers of 0 solve the rows of a
// DOF that nothing drives, so their scatter says nothing.
Eigen::VectorXd Solve(const Balance& balance, Eigen::Index num, Vector6* scatter) {
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(num);
  std::array<bool, 6> is_driven = {};
  for (std::size_t i = 0; i < balance.rows.size(); ++i) {
    if (balance.right[i] != 0.0) is_driven[static_cast<std::size_t>(balance.dof[i])] = true;
  }
  for (int pass = 0; pass < 3; ++pass) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(num, num);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(num);
    Vector6 squares = Vector6::Zero(), count = Vector6::Constant(1e-9);
    for (std::size_t i = 0; i < balance.rows.size(); ++i) {
      const double miss = balance.right[i] - balance.rows[i].dot(solution);
      squares[balance.dof[i]] += miss * miss;
      count[balance.dof[i]] += 1.0;
    }
    for (int i = 0; i < 6; ++i) (*scatter)[i] = std::sqrt(squares[i] / count[i]) + 1e-12;
    FillUndriven(is_driven, scatter);
    for (std::size_t i = 0; i < balance.rows.size(); ++i) {
      const double weight = 1.0 / ((*scatter)[balance.dof[i]] * (*scatter)[balance.dof[i]]);
      normal.selfadjointView<Eigen::Lower>().rankUpdate(balance.rows[i], weight);
      right += weight * balance.right[i] * balance.rows[i];
    }
    normal = normal.selfadjointView<Eigen::Lower>();
    const Eigen::VectorXd diagonal = normal.diagonal().cwiseMax(1e-300);
    const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    scaled.diagonal().array() += kRidge;
    solution = scale.asDiagonal() * SolveSymmetric(scaled, scale.cwiseProduct(right));
  }
  return solution;
}

// The model with the numbers that are not free; of the others the inertia is that of the body
// alone, how late a command is stays, since (6) is linear near it only, and so does a bound; the
// rest is 0.
CoupledModel KnownOf(const MotionStructure& structure,
                     const CoupledModel& held,
                     const RigidBody& body) {
  const Matrix6 of_body = KnownInertia(body);
  CoupledModel known = held;
  known.dofs = structure.dofs;
  known.coriolis = structure.coriolis;
  for (const FreeEntry& entry : structure.entries) {
    if (IsLateness(entry) || IsLimit(entry)) continue;
    const bool is_inertia = entry.kind == Kind::kInertia;
    SetValue(entry, is_inertia ? of_body(Index(entry.row), Index(entry.column)) : 0.0, &known);
  }
  return known;
}

Balance BalanceOf(std::span<const CoupledData> logs,
                  const MotionStructure& structure,
                  const CoupledModel& known) {
  Balance balance;
  for (const CoupledData& log : logs) {
    const FinAngles angles(log.inputs.command, known);
    for (const CoupledSegment& segment : log.segments) {
      if (!segment.is_held_out) AddPieces(log, segment, structure, known, angles, &balance);
    }
  }
  return balance;
}

// How large forces, speeds and changes of speed are, by DOF.
struct Sizes {
  Vector6 force = Vector6::Zero(), speed = Vector6::Zero(), impulse = Vector6::Zero(),
          change = Vector6::Zero();
};

Sizes SizesOf(std::span<const CoupledData> logs, const CoupledModel& held) {
  Sizes sizes;
  double num = 0.0;
  for (const CoupledData& log : logs) {
    for (const CoupledSegment& segment : log.segments) {
      if (segment.is_held_out) continue;
      for (const SampleWindow& window : WindowsOf(segment, 2.0 * kPiece)) {
        const double from = segment.time[window.begin], to = segment.time[window.end - 1];
        const Vector6 first = MeasuredState(segment, window.begin).nu;
        const Vector6 impulse = ThrustImpulse(log.inputs.command, from, to, held) +
                                (to - from) * ShaftForcesAt(log.inputs.command, from, first, held);
        const Vector6 change = MeasuredState(segment, window.end - 1).nu - first;
        sizes.impulse += impulse.cwiseAbs2();
        sizes.change += change.cwiseAbs2();
        sizes.force += (impulse / std::max(to - from, 1e-9)).cwiseAbs2();
        sizes.speed += first.cwiseAbs2();
        num += 1.0;
      }
    }
  }
  for (Vector6* size : {&sizes.force, &sizes.speed, &sizes.impulse, &sizes.change}) {
    *size = (*size / std::max(num, 1.0)).cwiseSqrt().cwiseMax(kNoForce);
  }
  return sizes;
}

// A little of what is natural of an effect, from which a search gets away.
double LeastEffect(const FreeEntry& entry, const Sizes& sizes) {
  const Quantity& quantity = entry.effect->info().parameters.front().quantity;
  const auto row = Index(entry.row);
  return kLeastDampingShare * std::pow(sizes.force[row], quantity.force) *
         std::pow(sizes.speed[row], quantity.speed);
}

}  // namespace

std::span<const double> LimitsTried(const FreeEntry& entry) {
  static constexpr std::array<double, 9> kRates = {0.03, 0.05, 0.08, 0.12, 0.2, 0.3, 0.5, 0.8, 1.5};
  static constexpr std::array<double, 7> kStalls = {0.06, 0.09, 0.13, 0.18, 0.25, 0.35, 0.5};
  if (entry.kind == Kind::kFinStall) return kStalls;
  return kRates;
}

double MomentumMisfit(std::span<const CoupledData> logs,
                      const MotionStructure& structure,
                      const CoupledModel& held) {
  const Balance balance = BalanceOf(logs, structure, KnownOf(structure, held, {}));
  Vector6 scatter;
  Solve(balance, static_cast<Eigen::Index>(structure.entries.size()), &scatter);
  double misfit = 0.0;
  for (const int dof : balance.dof) misfit += 2.0 * std::log(scatter[dof]);
  return misfit;
}

namespace {

// With the free bounds that it leaves infinite at the best of those tried, one after the other.
CoupledModel WithLimits(std::span<const CoupledData> logs,
                        const MotionStructure& structure,
                        CoupledModel held) {
  for (const FreeEntry& entry : structure.entries) {
    if (!IsLimit(entry) || std::isfinite(ValueIn(held, entry))) continue;
    double least = std::numeric_limits<double>::infinity();
    CoupledModel best = held;
    for (const double limit : LimitsTried(entry)) {
      SetValue(entry, limit, &held);
      const double misfit = MomentumMisfit(logs, structure, held);
      if (misfit >= least) continue;
      least = misfit;
      best = held;
    }
    held = best;
  }
  return held;
}

}  // namespace

CoupledModel MomentumStart(std::span<const CoupledData> logs,
                           const MotionStructure& structure,
                           const CoupledModel& held,
                           const RigidBody& body) {
  CoupledModel known = KnownOf(structure, WithLimits(logs, structure, held), body);
  const Balance balance = BalanceOf(logs, structure, known);
  Vector6 scatter;
  const Eigen::VectorXd solution =
      Solve(balance, static_cast<Eigen::Index>(structure.entries.size()), &scatter);
  for (std::size_t k = 0; k < structure.entries.size(); ++k) {
    const FreeEntry& entry = structure.entries[k];
    SetValue(entry, ValueIn(known, entry) + solution[static_cast<Eigen::Index>(k)], &known);
  }
  Sizes sizes = SizesOf(logs, held);
  for (const FreeEntry& entry : structure.entries) {
    if (!IsPositive(entry) || !IsEffect(entry)) continue;
    SetValue(entry, std::max(ValueIn(known, entry), LeastEffect(entry, sizes)), &known);
  }
  std::array<bool, 6> is_driven;
  for (std::size_t i = 0; i < 6; ++i) {
    is_driven[i] = sizes.force[static_cast<Eigen::Index>(i)] > kNoForce;
  }
  FillUndriven(is_driven, &sizes.force);
  FillUndriven(is_driven, &sizes.impulse);
  const Vector6 damping = kLeastDampingShare * sizes.force.cwiseQuotient(sizes.speed);
  const Vector6 quadratic = damping.cwiseQuotient(sizes.speed);
  const Vector6 inertia = kLeastInertiaShare * sizes.impulse.cwiseQuotient(sizes.change);
  const auto floor = [](const Vector6& least) { return least.cwiseMax(1e-6).cwiseMin(1e6).eval(); };
  return MovedInside(
      known, structure.entries, body, floor(damping), floor(quadratic), floor(inertia));
}

}  // namespace fathom
