// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/helmsman.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fathom {
namespace {

constexpr double kInDegrees = std::numbers::pi / 180.0;
constexpr double kFineSteps = 10.0, kFineStep = 1.0, kCoarseStep = 5.0;  // of a spiral [deg]
constexpr double kSteadyShare = 1e-3;                                    // of the largest yaw rate
constexpr double kDrifting = 0.05;  // of the speed at the begin, with the thrust off
constexpr int kZigzagTurns = 4;

}  // namespace

std::vector<double> HeldOrders(const Manoeuvre& manoeuvre) {
  const double angle = manoeuvre.angle;
  if (manoeuvre.kind == Manoeuvre::Kind::kPullOut) return {angle, 0.0, -angle, 0.0};
  if (manoeuvre.kind != Manoeuvre::Kind::kSpiral) return {};
  std::vector<double> to_port = {angle};
  const auto largest = static_cast<int>(std::ceil(angle / kInDegrees - 1e-9)) - 1;
  for (int degrees = largest; degrees >= -largest; --degrees) {
    const double step = std::abs(degrees) <= kFineSteps ? kFineStep : kCoarseStep;
    if (std::fmod(std::abs(degrees), step) == 0.0) to_port.push_back(degrees * kInDegrees);
  }
  to_port.push_back(-angle);
  std::vector<double> orders = to_port;
  orders.insert(orders.end(), to_port.rbegin() + 1, to_port.rend());
  return orders;
}

bool HasStopped(const Manoeuvre& manoeuvre, double ahead_at_begin, double ahead) {
  return ahead <= (manoeuvre.astern > 0.0 ? 0.0 : kDrifting * ahead_at_begin);
}

Helmsman::Helmsman(
    const Manoeuvre& manoeuvre, double step, double delay, double settle, double longest)
    : manoeuvre_(manoeuvre),
      step_(step),
      delay_(delay),
      settle_(settle),
      longest_(longest),
      held_(HeldOrders(manoeuvre)),
      side_(manoeuvre.first_side) {
  if (manoeuvre.kind == Manoeuvre::Kind::kStop) return;
  order_ = held_.empty() ? side_ * manoeuvre.angle : held_.front();
}

void Helmsman::See(const HelmView& view) {
  if (view.time >= next_time_) {
    order_ = next_order_;
    next_time_ = std::numeric_limits<double>::infinity();
  }
  switch (manoeuvre_.kind) {
    case Manoeuvre::Kind::kTurningCircle:
      is_done_ = side_ * view.heading >= 2.0 * std::numbers::pi;
      break;
    case Manoeuvre::Kind::kZigzag:
      SeeZigzag(view);
      break;
    case Manoeuvre::Kind::kStop:
      is_done_ = !views_.empty() && HasStopped(manoeuvre_, views_.front().ahead, view.ahead);
      break;
    case Manoeuvre::Kind::kSpiral:
    case Manoeuvre::Kind::kPullOut:
      SeeHeld(view);
      break;
  }
  views_.push_back(view);
}

// When the heading of the zigzag is reached, before a view that is beyond it or behind one that is
// not: there at a yaw rate that changes on as it did. Infinite: not foreseen.
double Helmsman::WhenReached(const HelmView& view) const {
  const double ahead = manoeuvre_.heading - side_ * view.heading;
  if (views_.empty()) {
    return ahead > 0.0 ? std::numeric_limits<double>::infinity() : view.time;
  }
  const HelmView& last = views_.back();
  const double since = view.time - last.time;
  if (ahead <= 0.0) {
    const double way = side_ * (view.heading - last.heading);
    return way > 0.0 ? view.time - std::min(-ahead / way, 1.0) * since : view.time;
  }
  const double rate = side_ * view.rate;
  const double change = side_ * (view.rate - last.rate) / since;
  const double squared = rate * rate + 2.0 * change * ahead;
  if (!(rate > 0.0) || !(squared > 0.0)) return std::numeric_limits<double>::infinity();
  return view.time + 2.0 * ahead / (rate + std::sqrt(squared));
}

void Helmsman::SeeZigzag(const HelmView& view) {
  const double reached = WhenReached(view);
  // An order that is due before the next look is given now, but for the last, behind which nothing
  // is looked at.
  const bool is_last = num_turned_ + 1 == kZigzagTurns;
  const bool is_reached = side_ * view.heading >= manoeuvre_.heading;
  if (!is_reached && (is_last || !(reached + delay_ < view.time + step_))) return;
  side_ = -side_;
  next_order_ = side_ * manoeuvre_.angle;
  next_time_ = std::max(reached + delay_, view.time);
  if (next_time_ <= view.time) {
    order_ = next_order_;
    next_time_ = std::numeric_limits<double>::infinity();
  }
  ++num_turned_;
  is_done_ = num_turned_ >= kZigzagTurns;
}

bool Helmsman::IsSteady(double time) const {
  if (time - since_ < 2.0 * settle_) return false;
  const auto begin = std::ranges::partition_point(
      views_, [&](const HelmView& view) { return view.time < time - settle_; });
  const auto [least, most] = std::minmax_element(
      begin, views_.end(), [](const HelmView& a, const HelmView& b) { return a.rate < b.rate; });
  return begin != views_.end() && most->rate - least->rate <= kSteadyShare * largest_rate_;
}

void Helmsman::SeeHeld(const HelmView& view) {
  largest_rate_ = std::max(largest_rate_, std::abs(view.rate));
  if (!IsSteady(view.time) && view.time - since_ < longest_) return;
  steady_.push_back({order_, view.rate});
  views_.clear();
  since_ = view.time;
  is_done_ = ++num_held_ == held_.size();
  if (!is_done_) order_ = held_[num_held_];
}

}  // namespace fathom
