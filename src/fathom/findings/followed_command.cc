// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/followed_command.h"

#include "fathom/base/quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kFollows = 0.5;
constexpr double kFarLess = 0.25;  // of what follows otherwise

// The command through a lag, at stamps.
std::vector<double> Lagged(const HeldCommand& command, double lag, std::span<const double> time) {
  std::vector<double> lagged;
  std::size_t next = 0;
  double state = 0.0, held = 0.0, at = time.empty() ? 0.0 : time.front();
  const auto go_to = [&](double t) {
    state += (held - state) * -std::expm1(-(t - at) / lag);
    at = t;
  };
  while (next < command.time.size() && command.time[next] <= at) held = command.value[next++];
  for (const double t : time) {
    for (; next < command.time.size() && command.time[next] <= t; ++next) {
      go_to(command.time[next]);
      held = command.value[next];
    }
    go_to(t);
    lagged.push_back(state);
  }
  return lagged;
}

double SquaredCorrelation(std::span<const double> a, std::span<const double> b) {
  const auto n = static_cast<double>(a.size());
  double mean_a = 0.0, mean_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / n;
    mean_b += b[i] / n;
  }
  double aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return aa > 0.0 && bb > 0.0 ? ab * ab / (aa * bb) : 0.0;
}

std::vector<double> MagnitudesOf(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

// Whether a tenth of the values lies on either side of 0, well away from it.
bool GoesBothWays(const std::vector<double>& values) {
  const double back = Quantile(values, 0.1), ahead = Quantile(values, 0.9);
  return back < 0.0 && ahead > 0.0 && std::min(-back, ahead) > 0.2 * std::max(-back, ahead);
}

// Whether none is below 0 but by noise.
bool NeverGoesBack(const std::vector<double>& values) {
  return Quantile(values, 0.01) > -0.1 * Quantile(values, 0.9);
}

Finding FindingOn(const Stream& velocity, Dof dof, const char* code, std::string sentence) {
  return {Severity::kWarning,
          code,
          std::move(sentence),
          FindingPlace{"velocity.csv",
                       std::string(VelocityColumn(dof)),
                       {velocity.time.front(), velocity.time.back()}}};
}

// The velocity of `dof` in a stream that holds it, against its command.
std::vector<Finding> CheckSigns(const Stream& stream, const HeldCommand& command, Dof dof) {
  const std::vector<double>& time = stream.time;
  const std::vector<double>& velocity = *stream.Find(VelocityColumn(dof));
  const std::vector<double> force = command.At(time);
  const bool is_speed = NeverGoesBack(velocity) && GoesBothWays(force);
  const bool is_thrust = NeverGoesBack(force) && GoesBothWays(velocity);
  if (!is_speed && !is_thrust) return {};
  const double follows =
      is_speed ? ShareFollowed(time, velocity, {command.time, MagnitudesOf(command.value)})
               : ShareFollowed(time, MagnitudesOf(velocity), command);
  if (!(follows > kFollows) || ShareFollowed(time, velocity, command) >= kFarLess * follows) {
    return {};
  }
  const std::string_view u = VelocityColumn(dof), tau = ForceColumn(dof);
  if (is_speed) {
    return {FindingOn(
        stream,
        dof,
        "unsigned_speed",
        fmt::format("velocity.csv: {} is never below 0 though {} goes both ways, and follows its "
                    "magnitude: it is a speed without sign.",
                    u,
                    tau))};
  }
  return {FindingOn(stream,
                    dof,
                    "unsigned_command",
                    fmt::format("command.csv: {} is never below 0 though {} goes both ways, and "
                                "its magnitude follows it: the command has lost its sign.",
                                tau,
                                u))};
}

// The command of a DOF; nothing if the log has none.
HeldCommand CommandAlong(const Log& log, Dof dof) {
  const auto* values = log.command ? log.command->Find(ForceColumn(dof)) : nullptr;
  return values == nullptr ? HeldCommand{} : HeldCommand{log.command->time, *values};
}

}  // namespace

double ShareFollowed(std::span<const double> time,
                     std::span<const double> value,
                     const HeldCommand& command) {
  double share = 0.0;
  for (const double lag : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0}) {
    share = std::max(share, SquaredCorrelation(value, Lagged(command, lag, time)));
  }
  return share;
}

std::vector<Finding> CheckFollowedCommand(const Log& log, Dof dof) {
  constexpr std::size_t kFewestRows = 100;
  if (!log.velocity || log.velocity->time.size() < kFewestRows) return {};
  const std::vector<double>& time = log.velocity->time;
  const auto* velocity = log.velocity->Find(VelocityColumn(dof));
  const HeldCommand command = CommandAlong(log, dof);
  if (velocity == nullptr || command.time.empty()) return {};
  const double own = ShareFollowed(time, *velocity, command);
  for (const Dof other : kAllDofs) {
    const auto* of_other = log.velocity->Find(VelocityColumn(other));
    if (other == dof || IsAngular(other) != IsAngular(dof) || of_other == nullptr) continue;
    const double follows = ShareFollowed(time, *of_other, command);
    const double less = kFarLess * follows;
    if (follows > kFollows && own < less &&
        ShareFollowed(time, *of_other, CommandAlong(log, other)) < less) {
      return {
          FindingOn(*log.velocity,
                    dof,
                    "swapped_axes",
                    fmt::format("velocity.csv: {} does not follow {}, but {} does (R^2 {:.2f}): "
                                "the axes are swapped.",
                                VelocityColumn(dof),
                                ForceColumn(dof),
                                VelocityColumn(other),
                                follows))};
    }
  }
  return CheckSigns(*log.velocity, command, dof);
}

}  // namespace fathom
