// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_rate.h"

#include "fathom/vehicle/coupled/coriolis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace fathom {
namespace {

// The world's down, seen in the body.
Eigen::Vector3d DownIn(const Eigen::Vector4d& q) {
  return {2.0 * (q[0] * q[2] - q[3] * q[1]),
          2.0 * (q[1] * q[2] + q[3] * q[0]),
          q[3] * q[3] + q[2] * q[2] - q[0] * q[0] - q[1] * q[1]};
}

Vector6 Restoring(const CoupledModel& model, const Eigen::Vector3d& down) {
  Vector6 force;
  force << model.net_buoyancy * down, model.righting_roll * down[1],
      -model.righting_pitch * down[0], 0.0;
  return force;
}

// What a momentum does in a turning frame: CoriolisForceOfMomentum() as a matrix.
Matrix6 ByMomentum(const Vector6& nu) {
  Matrix6 by = Matrix6::Zero();
  by.topLeftCorner<3, 3>() = by.bottomRightCorner<3, 3>() = CrossMatrix(nu.tail<3>());
  by.bottomLeftCorner<3, 3>() = CrossMatrix(nu.head<3>());
  return by;
}

Eigen::Index OnlyRowOf(const FreeEntry& entry) {
  switch (entry.kind) {
    case FreeEntry::Kind::kLinearDamping:
    case FreeEntry::Kind::kQuadraticDamping:
    case FreeEntry::Kind::kRightingMoment:
    case FreeEntry::Kind::kOffset:
    case FreeEntry::Kind::kRunOffset:
    case FreeEntry::Kind::kLift:
      return Index(entry.row);
    case FreeEntry::Kind::kEffect:
      return IsOfThrust(*entry.effect) ? -1 : Index(entry.row);
    default:
      return -1;
  }
}

}  // namespace

CoupledRate::CoupledRate(const CoupledModel& model,
                         std::span<const FreeEntry> entries,
                         const CoupledCommand& command,
                         const std::string& log)
    : model_(model),
      entries_(entries),
      command_(command),
      shaft_of_entry_(entries.size()),
      fin_of_entry_(entries.size()),
      has_lift_(!model.lift.isZero(0.0)),
      offset_(model.offset) {
  const auto of_run = model.run_offset.find(log);
  if (of_run != model.run_offset.end()) offset_ += of_run->second;
  const auto value_or_0 = [](const std::map<std::string, double>& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? 0.0 : found->second;
  };
  const std::vector<CommandedFin>& fins = command.fins;
  for (std::size_t k = 0; k < fins.size(); ++k) {
    for (std::size_t e = 0; e < entries.size(); ++e) {
      if (entries[e].actuator == fins[k].name) fin_of_entry_[e] = k;
    }
    fins_.push_back({k,
                     value_or_0(model.fin_force, fins[k].name),
                     value_or_0(model.fin_race, fins[k].name),
                     value_or_0(model.fin_neutral, fins[k].name)});
    const auto stuck = model.fin_stuck.find(fins[k].name);
    if (stuck != model.fin_stuck.end()) fins_.back().stuck = stuck->second;
    const auto stall = model.fin_stall.find(fins[k].name);
    if (stall != model.fin_stall.end()) fins_.back().stall = stall->second;
    fins_.back().shafts = RaceShafts(command, fins[k]);
  }
  for (std::size_t k = 0; k < command.shafts.size(); ++k) {
    const std::string& name = command.shafts[k].shaft.name;
    const auto gain = model.thrust_gain.find(name);
    shafts_.push_back({k, gain == model.thrust_gain.end() ? 1.0 : gain->second});
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const bool is_its =
          entries[e].kind == FreeEntry::Kind::kThrustGain && entries[e].actuator == name;
      if (is_its) shaft_of_entry_[e] = k;
    }
  }
  for (const Effect* effect : WaterEffects()) {
    const auto values = model.effects.find(std::string(effect->info().name));
    if (values == model.effects.end()) continue;
    for (const Dof dof : model.dofs) {
      const double value = values->second[Index(dof)];
      if (value != 0.0) effects_.push_back({effect, Index(dof), value});
    }
  }
  for (const FreeEntry& entry : entries) {
    rows_.push_back(OnlyRowOf(entry));
    is_of_other_run_.push_back(IsOfRun(entry) && entry.actuator != log);
  }
  is_usable_ = IsPositiveDefinite(model.inertia, model.dofs);
  if (!is_usable_) return;
  const auto size = static_cast<Eigen::Index>(model.dofs.size());
  Eigen::MatrixXd part(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      part(i, j) = model.inertia(Index(model.dofs[i]), Index(model.dofs[j]));
    }
  }
  const Eigen::MatrixXd inverse = part.inverse();
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto dof = Index(model.dofs[i]);
    scale_[dof] = 1.0 / std::sqrt(part(i, i));
    for (Eigen::Index j = 0; j < size; ++j) inverse_(dof, Index(model.dofs[j])) = inverse(i, j);
  }
  for (const auto& [dof, moment] :
       {std::pair{Dof::kRoll, model.righting_roll}, std::pair{Dof::kPitch, model.righting_pitch}}) {
    const double scale = scale_[Index(dof)];
    restoring_rate_ = std::max(restoring_rate_, scale * std::sqrt(std::abs(moment)));
  }
}

CoupledRate::Race CoupledRate::RaceOf(const ModelFin& fin,
                                      const Vector6& nu,
                                      const CoupledDrive& drive) const {
  Race race = {drive.races[fin.at]};
  for (const std::size_t k : fin.shafts) {
    const CommandedShaft& shaft = command_.shafts[k];
    const ShaftThrust at = ShaftThrustAt(shaft.shaft, drive.turns[k], shaft.push.dot(nu));
    race.value += at.thrust;
    race.by_nu += at.by_speed * shaft.push;
  }
  if (!fin.shafts.empty() && race.value <= 0.0) race = {};
  return race;
}

FinLoad CoupledRate::LoadOf(const ModelFin& fin,
                            const Vector6& nu,
                            const CoupledDrive& drive) const {
  const double angle = fin.stuck.value_or(drive.angles[fin.at] - fin.neutral);
  const FinArms& arms = command_.fins[fin.at].arms;
  if (fin.shafts.empty()) {
    return FinLoadAt(arms, nu, angle, fin.race * drive.races[fin.at], fin.stall);
  }
  const Race race = RaceOf(fin, nu, drive);
  FinLoad at = FinLoadAt(arms, nu, angle, fin.race * race.value, fin.stall);
  at.load_by_nu += at.load_by_race * fin.race * race.by_nu;
  return at;
}

CoupledRate::ModelEffect CoupledRate::EffectOf(const FreeEntry& entry) const {
  for (const ModelEffect& effect : effects_) {
    if (effect.effect == entry.effect && effect.row == Index(entry.row)) return effect;
  }
  return {entry.effect, Index(entry.row), 0.0};
}

EffectResistance CoupledRate::ResistanceAt(const ModelEffect& effect, const Vector6& nu) const {
  const double quadratic = model_.quadratic_damping(effect.row, effect.row);
  return ResistanceOf(*effect.effect, effect.value, nu[effect.row], quadratic);
}

CoupledFlow CoupledRate::At(const CoupledFlow& state, const CoupledDrive& drive) const {
  const Vector6& nu = state.nu;
  Vector6 force = drive.tau - offset_ - Restoring(model_, DownIn(state.attitude));
  force.noalias() -= model_.linear_damping * nu;
  force.noalias() -= model_.quadratic_damping * nu.cwiseAbs().cwiseProduct(nu);
  if (has_lift_) force.noalias() -= nu[0] * (model_.lift * nu);
  for (const ModelFin& fin : fins_) force += fin.force * LoadOf(fin, nu, drive).Force();
  for (const ModelShaft& shaft : shafts_) {
    const CommandedShaft& commanded = command_.shafts[shaft.at];
    force +=
        shaft.gain * ThrustOnVehicle(commanded, drive.turns[shaft.at], nu).thrust * commanded.push;
  }
  for (const ModelEffect& effect : effects_) force[effect.row] -= ResistanceAt(effect, nu).force;
  if (model_.coriolis) force -= CoriolisForce(model_.inertia, nu);
  CoupledFlow rate;
  rate.nu.noalias() = inverse_ * force;
  const Eigen::Quaterniond q(state.attitude);
  rate.attitude = 0.5 * (q * Eigen::Quaterniond(0.0, nu[3], nu[4], nu[5])).coeffs();
  rate.position = q * Eigen::Vector3d(nu.head<3>());
  return rate;
}

Matrix6 CoupledRate::ForceJacobian(const Vector6& nu, const CoupledDrive& drive) const {
  Matrix6 jacobian = -model_.linear_damping;
  jacobian -= model_.quadratic_damping * (2.0 * nu.cwiseAbs()).asDiagonal();
  if (has_lift_) {
    jacobian -= nu[0] * model_.lift;
    jacobian.col(0) -= model_.lift * nu;
  }
  for (const ModelFin& fin : fins_) {
    const FinLoad at = LoadOf(fin, nu, drive);
    jacobian.noalias() += fin.force * at.push * at.load_by_nu.transpose();
  }
  for (const ModelShaft& shaft : shafts_) {
    const CommandedShaft& commanded = command_.shafts[shaft.at];
    const double by_speed = ThrustOnVehicle(commanded, drive.turns[shaft.at], nu).by_speed;
    jacobian.noalias() += shaft.gain * by_speed * commanded.push * commanded.push.transpose();
  }
  for (const ModelEffect& effect : effects_) {
    jacobian(effect.row, effect.row) -= ResistanceAt(effect, nu).by_speed;
  }
  if (model_.coriolis) jacobian -= CoriolisJacobian(model_.inertia, nu);
  return jacobian;
}

TangentLaw CoupledRate::LawAt(const CoupledFlow& state, const CoupledDrive& drive) const {
  const Vector6& nu = state.nu;
  const Eigen::Matrix3d down_by_turn = CrossMatrix(DownIn(state.attitude));
  const Eigen::Matrix3d world_from_body = Eigen::Quaterniond(state.attitude).toRotationMatrix();
  TangentLaw law;
  law.force.leftCols<6>() = ForceJacobian(nu, drive);
  law.force.topRightCorner<3, 3>() = -model_.net_buoyancy * down_by_turn;
  law.force.row(3).tail<3>() = -model_.righting_roll * down_by_turn.row(1);
  law.force.row(4).tail<3>() = model_.righting_pitch * down_by_turn.row(0);
  law.force.row(5).tail<3>().setZero();
  law.turn = -CrossMatrix(nu.tail<3>());
  law.position.leftCols<3>() = world_from_body;
  law.position.middleCols<3>(3).setZero();
  law.position.rightCols<3>() = -world_from_body * CrossMatrix(nu.head<3>());
  return law;
}

void CoupledRate::ForcesOfEntries(const CoupledFlow& state,
                                  const CoupledFlow& rate,
                                  const CoupledDrive& drive,
                                  Eigen::Matrix<double, 6, Eigen::Dynamic>* forces) const {
  const Vector6& nu = state.nu;
  const Eigen::Vector3d down = DownIn(state.attitude);
  const Matrix6 by_momentum = model_.coriolis ? ByMomentum(nu) : Matrix6::Zero();
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const FreeEntry& entry = entries_[k];
    const auto row = Index(entry.row), column = Index(entry.column);
    auto force = forces->col(static_cast<Eigen::Index>(k));
    switch (entry.kind) {
      case FreeEntry::Kind::kInertia:
        // -E rate - C(E nu) nu; off the diagonal E has the entry twice.
        force = by_momentum.col(row) * -nu[column];
        force[row] -= rate.nu[column];
        if (row == column) break;
        force -= by_momentum.col(column) * nu[row];
        force[column] -= rate.nu[row];
        break;
      case FreeEntry::Kind::kLinearDamping:
        force[row] = -nu[column];
        break;
      case FreeEntry::Kind::kQuadraticDamping:
        force[row] = -std::abs(nu[column]) * nu[column];
        for (const ModelEffect& effect : effects_) {
          if (effect.row != row || row != column) continue;
          force[row] -= ResistanceAt(effect, nu).by_quadratic_damping;
        }
        break;
      case FreeEntry::Kind::kRightingMoment:
        force[row] = entry.row == Dof::kRoll ? -down[1] : down[0];
        break;
      case FreeEntry::Kind::kNetBuoyancy:
        force << -down, 0.0, 0.0, 0.0;
        break;
      case FreeEntry::Kind::kOffset:
        force[row] = -1.0;
        break;
      case FreeEntry::Kind::kRunOffset:
        force[row] = is_of_other_run_[k] ? 0.0 : -1.0;
        break;
      case FreeEntry::Kind::kThrustGain:
        force = drive.tau_by_entry[k];
        if (shaft_of_entry_[k]) {
          const CommandedShaft& shaft = command_.shafts[*shaft_of_entry_[k]];
          force += ThrustOnVehicle(shaft, drive.turns[*shaft_of_entry_[k]], nu).thrust * shaft.push;
        }
        break;
      case FreeEntry::Kind::kThrustAngle:
      case FreeEntry::Kind::kThrusterLag:
        force = drive.tau_by_entry[k];
        break;
      case FreeEntry::Kind::kTimeOffset:
        force = drive.tau_by_entry[k] + ForceByAngles(k, nu, drive);
        break;
      case FreeEntry::Kind::kFinLag:
      case FreeEntry::Kind::kFinRateLimit:
        force = ForceByAngles(k, nu, drive);
        break;
      case FreeEntry::Kind::kEffect:
        if (IsOfThrust(*entry.effect)) {
          force = drive.tau_by_entry[k];
        } else {
          force[row] = -ResistanceAt(EffectOf(entry), nu).by_value;
        }
        break;
      case FreeEntry::Kind::kThrusterEffect:
        force = drive.tau_by_entry[k];
        break;
      case FreeEntry::Kind::kCurrent:
        force.setZero();  // it acts by the start and the outputs
        break;
      case FreeEntry::Kind::kLift:
        force[row] = -nu[0] * nu[column];
        break;
      case FreeEntry::Kind::kFinForce:
        force = LoadOf(fins_[fin_of_entry_[k]], nu, drive).Force();
        break;
      case FreeEntry::Kind::kFinRace: {
        const ModelFin& fin = fins_[fin_of_entry_[k]];
        const FinLoad at = LoadOf(fin, nu, drive);
        force = fin.force * RaceOf(fin, nu, drive).value * at.load_by_race * at.push;
        break;
      }
      case FreeEntry::Kind::kFinStall: {
        const ModelFin& fin = fins_[fin_of_entry_[k]];
        const FinLoad at = LoadOf(fin, nu, drive);
        force = fin.force * at.load_by_stall * at.push;
        break;
      }
      case FreeEntry::Kind::kFinNeutral: {
        const ModelFin& fin = fins_[fin_of_entry_[k]];
        force = -fin.force * LoadOf(fin, nu, drive).ForceByAngle();
        break;
      }
      case FreeEntry::Kind::kFinStuck: {
        const ModelFin& fin = fins_[fin_of_entry_[k]];
        force = fin.force * LoadOf(fin, nu, drive).ForceByAngle();
        break;
      }
    }
  }
}

Vector6 CoupledRate::ForceByAngles(std::size_t entry,
                                   const Vector6& nu,
                                   const CoupledDrive& drive) const {
  Vector6 force = Vector6::Zero();
  if (drive.angles_by_entry.empty()) return force;
  for (const ModelFin& fin : fins_) {
    const double by = drive.angles_by_entry[entry][fin.at];
    if (by == 0.0 || fin.stuck) continue;
    force += by * fin.force * LoadOf(fin, nu, drive).ForceByAngle();
  }
  return force;
}

double CoupledRate::Quickest(const CoupledFlow& state, const Matrix6& force_by_nu) const {
  const Matrix6 scaled = scale_.asDiagonal() * force_by_nu * scale_.asDiagonal();
  return std::max({scaled.norm(), restoring_rate_, state.nu.tail<3>().norm()});
}

}  // namespace fathom
