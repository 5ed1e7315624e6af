// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/simple_manoeuvres.h"

#include "fathom/planning/command_block.h"
#include "fathom/planning/kept_limits.h"
#include "fathom/planning/planned_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLookedAtEvery = 0.2;  // [s]
constexpr int kNumSizes = 20;

// In how many whole seconds the speed settles, 4 to 15: a minute has to hold two changes and more.
int SettlingTime(const UncoupledModel<double>& model, double speed) {
  const double damping = model.linear_damping + 2.0 * model.quadratic_damping * speed;
  const double settled = damping > 0.0 ? 3.0 * model.inertia / damping : 15.0;
  return static_cast<int>(std::clamp(std::round(settled), 4.0, 15.0));
}

// The force of a manoeuvre in each second, in shares of its size.
using Shape = std::function<double(int second)>;

// Of the greatest size that keeps the speed; its size goes to `size`. Nothing if none does.
std::optional<HeldCommand> Largest(const FittedModel& model,
                                   double force,
                                   double speed,
                                   double duration,
                                   const Shape& shape,
                                   double* size) {
  PlanLimits limits;
  limits.speed = speed;
  const std::vector<double> stamps = PlannedStamps(duration, kLookedAtEvery);
  for (int k = kNumSizes; k >= 1; --k) {
    *size = force * k / kNumSizes;
    std::vector<double> forces;
    for (int second = 0; second < duration; ++second) forces.push_back(*size * shape(second));
    HeldCommand command = CommandOfCells(forces, 1.0);
    const auto motion = MotionUnder(model.Extended(), model.dof, command, stamps);
    if (motion && KeepsLimits(*motion, limits)) return command;
  }
  return std::nullopt;
}

}  // namespace

std::vector<SimpleManoeuvre> SimpleManoeuvres(const FittedModel& model,
                                              double force,
                                              double speed,
                                              double duration) {
  const int slow = SettlingTime(model.model, speed);
  const int quick = std::max(1, slow / 4);
  std::vector<SimpleManoeuvre> manoeuvres;
  const auto add = [&](const Shape& shape, auto words) {
    double size = 0.0;
    auto command = Largest(model, force, speed, duration, shape, &size);
    if (!command) return;
    manoeuvres.push_back(
        {words(fmt::format("{:.3g} {}", size, model.force_unit)), *std::move(command)});
  };
  for (const int hold : {slow, quick}) {
    add([=](int second) { return second / hold % 2 == 0 ? 1.0 : -1.0; },
        [=](const std::string& size) {
          return fmt::format(
              "{} one way for {} s, then as long the other way, over and over", size, hold);
        });
  }
  add(
      [=](int second) {
        return std::array{1.0, 0.0, -1.0, 0.0}[second / slow % 4];
      },
      [=](const std::string& size) {
        return fmt::format(
            "{} one way for {} s, let it coast as long, the same the other way, over and over",
            size,
            slow);
      });
  add([=](int second) { return 0.25 * (1 + second * 4 / static_cast<int>(duration)); },
      [=](const std::string& size) {
        return fmt::format("stairs of a quarter, a half, three quarters and all of {}, {:g} s each",
                           size,
                           0.25 * duration);
      });
  add([=](int second) { return second / slow % 2 == 0 ? 0.25 : -0.25; },
      [=](const std::string& size) {
        return fmt::format(
            "slowly, a quarter of {} one way for {} s, then as long the other way", size, slow);
      });
  return manoeuvres;
}

}  // namespace fathom
