// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/kept_wrench.h"

#include "fathom/planning/planned_motion.h"

#include <algorithm>
#include <utility>

namespace fathom {
namespace {

constexpr double kLimitPeriod = 0.2;  // of the stamps [s]
constexpr int kStampsOfPiece = 50;

}  // namespace

std::vector<double> WrenchLimitStamps(double hold, double duration) {
  return LimitStamps(hold, duration + kCoastAfterwards, kLimitPeriod);
}

KeptWrench::KeptWrench(const std::vector<CoupledModel>& models,
                       const CoupledLimits& limits,
                       double duration)
    : models_(models), limits_(limits) {
  for (const double stamp : WrenchLimitStamps(limits.shortest_hold, duration)) {
    if (pieces_.empty() || pieces_.back().stamps.size() == kStampsOfPiece) {
      pieces_.push_back({pieces_.empty() ? 0.0 : pieces_.back().stamps.back(), {}});
    }
    pieces_.back().stamps.push_back(stamp);
  }
  known_ends_.resize(models.size());
}

bool KeptWrench::KeptByFirst(const CoupledCommand& command) {
  CoupledInputs inputs;
  inputs.command = command;
  Ends ends;
  return Keeps(0, inputs, NumShared(command), &ends);
}

bool KeptWrench::KeptByAll(const CoupledCommand& command) {
  CoupledInputs inputs;
  inputs.command = command;
  const std::size_t num_shared = NumShared(command);
  std::vector<Ends> ends(models_.size());
  if (!Keeps(broke_last_, inputs, num_shared, &ends[broke_last_])) return false;
  for (std::size_t model = 0; model < models_.size(); ++model) {
    if (model == broke_last_ || Keeps(model, inputs, num_shared, &ends[model])) continue;
    broke_last_ = model;
    return false;
  }
  known_ = command;
  known_ends_ = std::move(ends);
  return true;
}

std::size_t KeptWrench::NumShared(const CoupledCommand& command) const {
  std::size_t row = 0;
  const std::size_t num_rows = std::min(command.time.size(), known_.time.size());
  while (row < num_rows && command.time[row] == known_.time[row] &&
         command.force[row] == known_.force[row]) {
    ++row;
  }
  // All that is known, or nothing, where no row tells them apart.
  if (row == known_.time.size() && row == command.time.size()) return known_ends_.front().size();
  const auto at = [&](const CoupledCommand& of) {
    return row < of.time.size() ? of.time[row] : pieces_.back().stamps.back();
  };
  const double differs = std::min(at(command), at(known_));
  std::size_t num = 0;
  while (num < known_ends_.front().size() && pieces_[num].stamps.back() <= differs) ++num;
  return num;
}

bool KeptWrench::Keeps(std::size_t model,
                       const CoupledInputs& inputs,
                       std::size_t num_shared,
                       Ends* ends) {
  const Ends& known = known_ends_[model];
  ends->assign(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(num_shared));
  CoupledOutputs outputs;
  for (std::size_t i = num_shared; i < pieces_.size(); ++i) {
    const CoupledState start = i == 0 ? CoupledState() : ends->back();
    const CoupledStamps stamps = {pieces_[i].from, {}, pieces_[i].stamps};
    if (!RunCoupled(models_[model], inputs, start, stamps, &outputs)) return false;
    if (!KeepsLimits(outputs.pose, limits_)) return false;
    ends->push_back(outputs.pose.back());
  }
  return true;
}

}  // namespace fathom
