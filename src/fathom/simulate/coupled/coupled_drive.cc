// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_drive.h"

#include "fathom/simulate/coupled/asked_force.h"
#include "fathom/vehicle/coupled/turned_about_z.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kLagsThatCount = 20.0;  // what is older leaves e^-20 of itself

// A step within a lag covers a half of it. Shorter lags than twice the shortest step are as good as
// none: an error of a share of them is lost in the clocks.
constexpr double kShareOfLag = 0.5, kShortestStepOfLag = 0.0025;  // [s]

void CheckSizes(const CoupledCommand& command) {
  CHECK(command.force.empty() || command.force.size() == command.time.size());
  for (const CommandedThruster& thruster : command.thrusters) {
    CHECK_EQ(thruster.thrust.size(), command.time.size());
  }
  for (const CommandedFin& fin : command.fins) CHECK_EQ(fin.angle.size(), command.time.size());
  for (const CommandedShaft& shaft : command.shafts) {
    CHECK_EQ(shaft.turns.size(), command.time.size());
  }
}

FinServo ServoOf(const CoupledModel& model, const std::string& fin) {
  FinServo servo;
  const auto lag = model.fin_lag.find(fin);
  if (lag != model.fin_lag.end()) servo.lag = lag->second;
  const auto rate = model.fin_rate_limit.find(fin);
  if (rate != model.fin_rate_limit.end()) servo.rate = rate->second;
  return servo;
}

}  // namespace

CommandedDrive::CommandedDrive(const CoupledModel& model,
                               std::span<const FreeEntry> entries,
                               const CoupledCommand& command)
    : model_(model), entries_(entries), command_(command), longest_lag_(model.thruster_lag) {
  CheckSizes(command);
  const Vector6 zero = Vector6::Zero();
  pushed_.assign(entries.size(), {zero, zero, zero});
  CHECK(!FinWithLagAndRateLimit(model));
  bool has_servo = false;
  for (const CommandedFin& fin : command.fins) {
    const FinServo& servo = fins_.emplace_back(ServoOf(model, fin.name));
    longest_lag_ = std::max(longest_lag_, servo.lag);
    has_limited_fin_ |= servo.IsLimited();
    has_servo |= !servo.IsAtOnce();
  }
  drive_.turns.assign(command.shafts.size(), 0.0);
  drive_.angles.assign(command.fins.size(), 0.0);
  drive_.races.assign(command.fins.size(), 0.0);
  drive_.tau_by_entry.assign(entries.size(), zero);
  if (has_servo) {
    drive_.angles_by_entry.assign(entries.size(), std::vector<double>(command.fins.size(), 0.0));
  }
}

double CommandedDrive::TimeOf(std::ptrdiff_t row) const {
  return command_.time[static_cast<std::size_t>(row)] + model_.time_offset;
}

std::ptrdiff_t CommandedDrive::RowAt(double t) const {
  const auto& time = command_.time;
  return std::upper_bound(time.begin(), time.end(), t - model_.time_offset) - time.begin() - 1;
}

void CommandedDrive::Begin(double t) {
  const Vector6 zero = Vector6::Zero();
  tau_ = {zero, zero, zero};
  for (Lagged<Vector6>& pushed : pushed_) pushed = {zero, zero, zero};
  for (FinServo& fin : fins_) fin.lagged = {0.0, 0.0, 0.0};
  std::fill(drive_.turns.begin(), drive_.turns.end(), 0.0);
  std::fill(drive_.races.begin(), drive_.races.end(), 0.0);
  const std::ptrdiff_t last = RowAt(t);
  // Of lags what came before counts too.
  row_ = longest_lag_ > 0.0 ? RowAt(t - kLagsThatCount * longest_lag_) : last;
  if (row_ >= 0) {
    Ask(0.0);
    tau_.begun = tau_.target;
    for (Lagged<Vector6>& pushed : pushed_) pushed.begun = pushed.target;
    for (FinServo& fin : fins_) fin.lagged.begun = fin.lagged.target;
  }
  if (has_limited_fin_) SlewTo(row_);
  while (row_ < last) Next();
  Arrive(t);
  Show(row_ < 0 ? 0.0 : t - TimeOf(row_));
}

void CommandedDrive::MoveTo(double t) {
  if (NextChange() > t) return;
  while (NextRow() <= t) Next();
  Arrive(t);
  Show(t - TimeOf(row_));
}

double CommandedDrive::NextChange() const {
  double next = NextRow();
  if (!has_limited_fin_) return next;
  for (const FinServo& fin : fins_) next = std::min(next, ArrivalOf(fin));
  return next;
}

double CommandedDrive::NextRow() const {
  if (row_ + 1 == std::ssize(command_.time)) return std::numeric_limits<double>::infinity();
  return TimeOf(row_ + 1);
}

double CommandedDrive::ArrivalOf(const FinServo& fin) const {
  if (!fin.IsLimited() || !fin.slewed.Moves()) return std::numeric_limits<double>::infinity();
  return TimeOf(row_) + fin.slewed.Needed(fin.rate);
}

const CoupledDrive& CommandedDrive::At(double t) {
  const bool stays = longest_lag_ <= 0.0 && !has_limited_fin_;
  if (!stays && row_ >= 0) Show(t - TimeOf(row_));
  return drive_;
}

double CommandedDrive::LongestStep() const {
  double longest = std::numeric_limits<double>::infinity();
  const auto consider = [&](double lag) {
    if (lag > 0.0) longest = std::min(longest, std::max(kShareOfLag * lag, kShortestStepOfLag));
  };
  consider(model_.thruster_lag);
  for (const FinServo& fin : fins_) consider(fin.lag);
  return longest;
}

void CommandedDrive::Next() {
  // Before the first row nothing acts, however long.
  const double held = row_ < 0 ? 0.0 : TimeOf(row_ + 1) - TimeOf(row_);
  ++row_;
  Ask(held);
}

void CommandedDrive::SlewTo(std::ptrdiff_t row) {
  for (std::size_t k = 0; k < fins_.size(); ++k) {
    FinServo& fin = fins_[k];
    fin.slewed = {};
    if (!fin.IsLimited()) continue;
    for (std::ptrdiff_t i = 0; i <= row; ++i) {
      const double held = i == 0 ? 0.0 : TimeOf(i) - TimeOf(i - 1);
      fin.Retarget(command_.fins[k].angle[static_cast<std::size_t>(i)], held);
    }
  }
}

void CommandedDrive::Arrive(double t) {
  if (!has_limited_fin_) return;
  for (FinServo& fin : fins_) {
    if (ArrivalOf(fin) <= t) fin.slewed.Arrive();
  }
}

void CommandedDrive::Ask(double held) {
  const auto row = static_cast<std::size_t>(row_);
  tau_.Retarget(AskedForce(command_, row, model_), held, model_.thruster_lag);
  for (std::size_t k = 0; k < pushed_.size(); ++k) {
    const Vector6 pushed = AskedForceBy(entries_[k], command_, row, model_);
    pushed_[k].Retarget(pushed, held, model_.thruster_lag);
  }
  for (std::size_t k = 0; k < fins_.size(); ++k) {
    fins_[k].Retarget(command_.fins[k].angle[row], held);
    drive_.races[k] = RaceThrust(command_, command_.fins[k], row);
  }
  for (std::size_t k = 0; k < command_.shafts.size(); ++k) {
    drive_.turns[k] = command_.shafts[k].turns[row];
  }
}

void CommandedDrive::Show(double since) {
  const double lag = model_.thruster_lag;
  drive_.tau = tau_.At(since, lag);
  for (std::size_t k = 0; k < fins_.size(); ++k) {
    drive_.angles[k] = fins_[k].At(since);
  }
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    Vector6& by = drive_.tau_by_entry[e];
    switch (entries_[e].kind) {
      case FreeEntry::Kind::kThrustGain:
      case FreeEntry::Kind::kEffect:
      case FreeEntry::Kind::kThrusterEffect:
        by = pushed_[e].At(since, lag);
        break;
      case FreeEntry::Kind::kThrustAngle:
        by = ByTurnAboutZ(drive_.tau);
        break;
      case FreeEntry::Kind::kThrusterLag:
        if (lag > 0.0) by = tau_.ByLag(since, lag);
        break;
      case FreeEntry::Kind::kTimeOffset:
        if (lag > 0.0) by = -tau_.Rate(since, lag);
        break;
      default:
        continue;
    }
  }
  if (!drive_.angles_by_entry.empty()) ShowAnglesByEntry(since);
}

void CommandedDrive::ShowAnglesByEntry(double since) {
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const FreeEntry& entry = entries_[e];
    for (std::size_t k = 0; k < fins_.size(); ++k) {
      const FinServo& fin = fins_[k];
      if (fin.IsAtOnce()) continue;
      double& by = drive_.angles_by_entry[e][k];
      if (entry.kind == FreeEntry::Kind::kTimeOffset) by = -fin.Speed(since);
      if (entry.actuator == command_.fins[k].name) by = fin.By(entry.kind, since);
    }
  }
}

}  // namespace fathom
