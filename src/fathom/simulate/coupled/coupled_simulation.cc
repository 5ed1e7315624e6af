// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_simulation.h"

#include "fathom/base/tiny_as_zero.h"
#include "fathom/simulate/coupled/coupled_drive.h"
#include "fathom/simulate/coupled/coupled_rate.h"
#include "fathom/simulate/coupled/water_frame.h"
#include "fathom/simulate/partner_signals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr double kSmallestCoupledStep = 5e-4;  // [s]; a vehicle so quick is a trial gone astray

// The weights of the cubic through both ends of a step: of the values and of the slopes.
struct HermiteWeights {
  double begin, end, begin_slope, end_slope;

  HermiteWeights(double share, double step) {
    const double s2 = share * share, s3 = s2 * share;
    begin = 2.0 * s3 - 3.0 * s2 + 1.0;
    end = 3.0 * s2 - 2.0 * s3;
    begin_slope = step * (s3 - 2.0 * s2 + share);
    end_slope = step * (s3 - s2);
  }

  template <typename A, typename B, typename C, typename D, typename Out>
  void Of(const A& x0, const B& x1, const C& v0, const D& v1, Out* out) const {
    *out = begin * x0 + end * x1 + begin_slope * v0 + end_slope * v1;
  }
};

void Advance(const CoupledFlow& from, const CoupledFlow& rate, double h, CoupledFlow* to) {
  to->nu = from.nu + h * rate.nu;
  to->attitude = from.attitude + h * rate.attitude;
  to->position = from.position + h * rate.position;
}

// Weights of the classical scheme: x + h/6 (k1 + 2 k2 + 2 k3 + k4).
void Sum(const CoupledFlow (&rates)[4], double h, CoupledFlow* x) {
  const double one = h / 6.0, two = h / 3.0;
  x->nu += one * (rates[0].nu + rates[3].nu) + two * (rates[1].nu + rates[2].nu);
  x->position +=
      one * (rates[0].position + rates[3].position) + two * (rates[1].position + rates[2].position);
  x->attitude +=
      one * (rates[0].attitude + rates[3].attitude) + two * (rates[1].attitude + rates[2].attitude);
}

// One run, with all that it works in. It is integrated in the frame that the water carries along.
class CoupledRun {
 public:
  CoupledRun(const CoupledModel& model,
             std::span<const FreeEntry> entries,
             const CoupledInputs& inputs,
             bool with_tangent,
             const CoupledSteps& steps = {})
      : model_(model),
        entries_(entries),
        inputs_(inputs),
        with_tangent_(with_tangent),
        steps_(steps),
        drive_(model, entries, inputs.command),
        rate_(model, entries, inputs.command, inputs.log),
        water_(model, entries, inputs),
        columns_(with_tangent ? NumCoupledColumns(model, entries) : 0),
        tangent_(CoupledTangent::Zero(12, columns_)),
        begin_tangent_(tangent_),
        begin_tangent_rate_(tangent_),
        end_tangent_rate_(tangent_),
        shown_(tangent_) {
    if (with_tangent) {
      for (auto& forces : forces_) forces.setZero(6, static_cast<Eigen::Index>(entries.size()));
    }
    for (const Dof dof : model.dofs) is_modelled_[Index(dof)] = true;
    for (const FreeEntry& entry : entries) {
      jumps_ = jumps_ || IsLateness(entry);
    }
  }

  bool Over(const CoupledState& start, const CoupledStamps& stamps, CoupledOutputs* outputs) {
    if (!rate_.IsUsable()) return false;
    Begin(start, stamps, outputs);
    const double last = std::max(stamps.velocity.empty() ? stamps.start : stamps.velocity.back(),
                                 stamps.pose.empty() ? stamps.start : stamps.pose.back());
    double t = stamps.start;
    Show(t, stamps, outputs);
    while (t < last) {
      SetMeasured(t, &state_);
      MoveCommandTo(t);
      double end = std::min(last, std::max(drive_.NextChange(), t));
      const CoupledDrive& drive = drive_.At(t);
      double rate;
      if (with_tangent_) {
        laws_[0] = rate_.LawAt(state_, drive);
        rate = rate_.Quickest(state_, laws_[0].force.leftCols<6>());
      } else {
        rate = rate_.Quickest(state_, rate_.ForceJacobian(state_.nu, drive));
      }
      if (!std::isfinite(rate)) return false;
      double longest = std::min(steps_.longest, steps_.share_of_time_constant / rate);
      if (longest < kSmallestCoupledStep) return false;
      longest = std::min(longest, drive_.LongestStep());
      // Equal steps to the next change.
      const double num_steps = std::ceil((end - t) / longest);
      if (num_steps > 1.0) end = t + (end - t) / num_steps;
      Step(t, end - t);
      ++outputs->num_steps;
      if (!state_.nu.allFinite() || !state_.position.allFinite()) return false;
      ShowWithin(t, end, stamps, outputs);
      t = end;
    }
    return true;
  }

 private:
  void Begin(const CoupledState& start, const CoupledStamps& stamps, CoupledOutputs* outputs) {
    state_ = {start.nu, start.attitude.normalized(), start.position};
    const auto first = static_cast<Eigen::Index>(entries_.size());
    const auto size = static_cast<Eigen::Index>(model_.dofs.size());
    if (with_tangent_) {
      for (Eigen::Index i = 0; i < size; ++i) tangent_(Index(model_.dofs[i]), first + i) = 1.0;
      tangent_.block<3, 3>(6, first + size).setIdentity();
    }
    outputs->velocity.resize(stamps.velocity.size());
    outputs->pose.resize(stamps.pose.size());
    const auto rows = [](std::size_t n) { return 6 * static_cast<Eigen::Index>(n); };
    outputs->velocity_sensitivity.resize(with_tangent_ ? rows(stamps.velocity.size()) : 0,
                                         columns_);
    outputs->pose_sensitivity.resize(with_tangent_ ? rows(stamps.pose.size()) : 0, columns_);
    outputs->num_steps = 0;
    next_velocity_ = next_pose_ = 0;
    start_ = stamps.start;
    if (water_.Flows()) water_.ToWater(&state_, with_tangent_ ? &tangent_ : nullptr);
    drive_.Begin(stamps.start);
  }

  // What a state in the frame of the water and its derivatives are over ground, at `t` of log time
  // [s].
  std::pair<const CoupledFlow&, const CoupledTangent&> OverGround(double t,
                                                                  const CoupledFlow& in_water,
                                                                  const CoupledTangent& tangent) {
    if (!water_.Flows()) return {in_water, tangent};
    over_ground_ = in_water;
    tangent_over_ground_ = tangent;
    water_.ToGround(t - start_, &over_ground_, with_tangent_ ? &tangent_over_ground_ : nullptr);
    return {over_ground_, tangent_over_ground_};
  }

  void SetMeasured(double t, CoupledFlow* state) {
    for (std::size_t i = 0; i < 6; ++i) {
      if (is_modelled_[i]) continue;
      state->nu[static_cast<Eigen::Index>(i)] = LineAt(inputs_.measured[i], t, &places_[i]).value;
    }
  }

  // Moves on to the row of the command that holds at `t`. What changes at once there changes later
  // by an offset or a lag: a tangent jumps by the rate before less the rate after.
  void MoveCommandTo(double t) {
    if (!with_tangent_ || !jumps_) {
      drive_.MoveTo(t);
      return;
    }
    if (drive_.NextChange() > t) return;
    const CoupledDrive before = drive_.At(t);
    drive_.MoveTo(t);
    const CoupledDrive& after = drive_.At(t);
    const Vector6 rate_after = rate_.At(state_, after).nu;
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      const FreeEntry& entry = entries_[k];
      if (!IsLateness(entry)) continue;
      CoupledDrive late = entry.kind == FreeEntry::Kind::kTimeOffset ? before : after;
      if (entry.kind == FreeEntry::Kind::kThrusterLag) late.tau = before.tau;
      for (std::size_t fin = 0; fin < late.angles.size(); ++fin) {
        const bool is_its = entry.kind == FreeEntry::Kind::kFinLag &&
                            inputs_.command.fins[fin].name == entry.actuator;
        if (is_its) late.angles[fin] = before.angles[fin];
      }
      tangent_.col(static_cast<Eigen::Index>(k)).head<6>() +=
          rate_.At(state_, late).nu - rate_after;
    }
  }

  // One step of the classical scheme; what it begins with stays for the outputs within. The law of
  // tangents at its begin is known.
  void Step(double t, double h) {
    constexpr double kShares[4] = {0.0, 0.5, 0.5, 1.0};
    begin_ = state_;
    CoupledFlow stage = state_;
    for (int k = 0; k < 4; ++k) {
      if (k > 0) Advance(begin_, rates_[k - 1], kShares[k] * h, &stage);
      const double at = t + kShares[k] * h;
      SetMeasured(at, &stage);
      const CoupledDrive& drive = drive_.At(at);
      rates_[k] = rate_.At(stage, drive);
      if (!with_tangent_) continue;
      if (k > 0) laws_[k] = rate_.LawAt(stage, drive);
      rate_.ForcesOfEntries(stage, rates_[k], drive, &forces_[k]);
    }
    Sum(rates_, h, &state_);
    state_.attitude.normalize();
    SetMeasured(t + h, &state_);
    if (with_tangent_) StepTangent(h);
  }

  void StepTangent(double h) {
    step_.Set(laws_, rate_.inverse_inertia(), h);
    tangent_.swap(begin_tangent_);
    for (Eigen::Index c = 0; c < columns_; ++c) {
      Eigen::Matrix<double, 12, 1> sum;
      const auto from = begin_tangent_.col(c);
      const auto& by = step_.by_tangent;
      sum = by.col(0) * from[0] + by.col(1) * from[1] + by.col(2) * from[2] + by.col(3) * from[3] +
            by.col(4) * from[4] + by.col(5) * from[5] + by.col(6) * from[6] + by.col(7) * from[7] +
            by.col(8) * from[8];
      sum.tail<3>() += from.tail<3>();
      if (c < static_cast<Eigen::Index>(entries_.size())) AddForces(c, &sum);
      tangent_.col(c) = sum;
    }
  }

  // What the forces of an entry do to its column within a step.
  void AddForces(Eigen::Index c, Eigen::Matrix<double, 12, 1>* sum) const {
    const Eigen::Index row = rate_.RowOfEntry(static_cast<std::size_t>(c));
    if (row >= 0) {
      *sum += step_.by_force[0].col(row) * forces_[0](row, c) +
              step_.by_force[1].col(row) * forces_[1](row, c) +
              step_.by_force[2].col(row) * forces_[2](row, c) +
              step_.by_force[3].col(row) * forces_[3](row, c);
      return;
    }
    for (int k = 0; k < 4; ++k) {
      const auto& by = step_.by_force[k];
      const auto force = forces_[k].col(c);
      *sum += by.col(0) * force[0] + by.col(1) * force[1] + by.col(2) * force[2] +
              by.col(3) * force[3] + by.col(4) * force[4] + by.col(5) * force[5];
    }
  }

  // The rate of a tangent, at a state whose law and forces of entries are known.
  void TangentRate(const TangentLaw& law,
                   const Eigen::Matrix<double, 6, Eigen::Dynamic>& forces,
                   const CoupledTangent& tangent,
                   CoupledTangent* rate) const {
    Eigen::Matrix<double, 6, Eigen::Dynamic> force = law.force * tangent.topRows<9>();
    force.leftCols(forces.cols()) += forces;
    rate->topRows<6>().noalias() = rate_.inverse_inertia() * force;
    rate->middleRows<3>(6) = tangent.middleRows<3>(3);
    rate->middleRows<3>(6).noalias() += law.turn * tangent.middleRows<3>(6);
    rate->bottomRows<3>().noalias() = law.position * tangent.topRows<9>();
  }

  // Outputs at the state that a run stands at.
  void Show(double t, const CoupledStamps& stamps, CoupledOutputs* outputs) {
    SetMeasured(t, &state_);
    if (next_velocity_ < stamps.velocity.size() && stamps.velocity[next_velocity_] <= t) {
      WriteVelocity(t, state_, tangent_, outputs);
    }
    if (next_pose_ < stamps.pose.size() && stamps.pose[next_pose_] <= t) {
      WritePose(t, state_, tangent_, outputs);
    }
  }

  // Outputs within a step, up to its end.
  void ShowWithin(double from, double to, const CoupledStamps& stamps, CoupledOutputs* outputs) {
    const auto is_within = [&](const std::vector<double>& time, std::size_t next) {
      return next < time.size() && time[next] < to;
    };
    if (is_within(stamps.velocity, next_velocity_) || is_within(stamps.pose, next_pose_)) {
      const CoupledDrive& drive = drive_.At(to);
      end_rate_ = rate_.At(state_, drive);
      if (with_tangent_) {
        TangentRate(laws_[0], forces_[0], begin_tangent_, &begin_tangent_rate_);
        rate_.ForcesOfEntries(state_, end_rate_, drive, &forces_[0]);
        TangentRate(rate_.LawAt(state_, drive), forces_[0], tangent_, &end_tangent_rate_);
      }
    }
    while (is_within(stamps.velocity, next_velocity_)) {
      const double t = stamps.velocity[next_velocity_];
      Interpolate(from, to, t);
      WriteVelocity(t, between_, shown_, outputs);
    }
    while (is_within(stamps.pose, next_pose_)) {
      const double t = stamps.pose[next_pose_];
      Interpolate(from, to, t);
      WritePose(t, between_, shown_, outputs);
    }
    Show(to, stamps, outputs);
  }

  void Interpolate(double from, double to, double t) {
    const HermiteWeights cubic((t - from) / (to - from), to - from);
    cubic.Of(begin_.nu, state_.nu, rates_[0].nu, end_rate_.nu, &between_.nu);
    cubic.Of(begin_.attitude,
             state_.attitude,
             rates_[0].attitude,
             end_rate_.attitude,
             &between_.attitude);
    between_.attitude.normalize();
    cubic.Of(begin_.position,
             state_.position,
             rates_[0].position,
             end_rate_.position,
             &between_.position);
    SetMeasured(t, &between_);
    if (!with_tangent_) return;
    cubic.Of(begin_tangent_, tangent_, begin_tangent_rate_, end_tangent_rate_, &shown_);
  }

  void WriteVelocity(double t,
                     const CoupledFlow& in_water,
                     const CoupledTangent& tangent_in_water,
                     CoupledOutputs* to) {
    const auto [state, tangent] = OverGround(t, in_water, tangent_in_water);
    to->velocity[next_velocity_] = state.nu;
    if (with_tangent_) {
      to->velocity_sensitivity.middleRows<6>(6 * static_cast<Eigen::Index>(next_velocity_)) =
          tangent.topRows<6>();
    }
    ++next_velocity_;
  }

  void WritePose(double t,
                 const CoupledFlow& in_water,
                 const CoupledTangent& tangent_in_water,
                 CoupledOutputs* to) {
    const auto [state, tangent] = OverGround(t, in_water, tangent_in_water);
    to->pose[next_pose_] = {state.nu, state.attitude, state.position};
    if (with_tangent_) {
      const auto row = 6 * static_cast<Eigen::Index>(next_pose_);
      to->pose_sensitivity.middleRows<6>(row) = tangent.bottomRows<6>();
    }
    ++next_pose_;
  }

  const CoupledModel& model_;
  std::span<const FreeEntry> entries_;
  const CoupledInputs& inputs_;
  const bool with_tangent_;
  const CoupledSteps steps_;
  CommandedDrive drive_;
  CoupledRate rate_;
  const WaterFrame water_;
  const Eigen::Index columns_;
  std::array<bool, 6> is_modelled_ = {};
  std::array<std::size_t, 6> places_ = {};  // of LineAt()

  CoupledFlow state_, begin_, between_, end_rate_;
  CoupledFlow rates_[4];
  CoupledTangent tangent_, begin_tangent_, begin_tangent_rate_, end_tangent_rate_, shown_;
  TangentLaw laws_[4];                                  // at the stages of a step
  Eigen::Matrix<double, 6, Eigen::Dynamic> forces_[4];  // of the entries, there
  TangentStep step_;

  double start_ = 0.0;  // [s]
  CoupledFlow over_ground_;
  CoupledTangent tangent_over_ground_;

  bool jumps_ = false;  // whether a tangent may, where the command changes
  std::size_t next_velocity_ = 0, next_pose_ = 0;
};

}  // namespace

int NumCoupledColumns(const CoupledModel& model, std::span<const FreeEntry> entries) {
  return static_cast<int>(entries.size() + model.dofs.size() + 3);
}

bool RunCoupled(const CoupledModel& model,
                const CoupledInputs& inputs,
                const CoupledState& start,
                const CoupledStamps& stamps,
                CoupledOutputs* outputs,
                const CoupledSteps& steps) {
  return CoupledRun(model, {}, inputs, false, steps).Over(start, stamps, outputs);
}

bool RunCoupledWithSensitivities(const CoupledModel& model,
                                 std::span<const FreeEntry> entries,
                                 const CoupledInputs& inputs,
                                 const CoupledState& start,
                                 const CoupledStamps& stamps,
                                 CoupledOutputs* outputs) {
  const TinyAsZero tiny_as_zero;
  return CoupledRun(model, entries, inputs, true).Over(start, stamps, outputs);
}

}  // namespace fathom
