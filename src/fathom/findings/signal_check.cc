// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/signal_check.h"

#include "fathom/base/interval95.h"
#include "fathom/base/median.h"
#include "fathom/base/plural.h"
#include "fathom/base/short_number.h"
#include "fathom/findings/batch_means.h"
#include "fathom/findings/pulse_widths.h"
#include "fathom/signal/filters/autoregression.h"
#include "fathom/signal/filters/integral.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <Eigen/Core>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kHighestSpeed = 20.0;    // [m/s] or [rad/s]
constexpr double kShortestStep = 1e-3;    // [s]
constexpr double kLongestStep = 1.0;      // [s]
constexpr double kJitter = 0.3;           // of the median step
constexpr double kGap = 5.0;              // median steps
constexpr double kPowerErrors = 3.0;      // standard errors below zero
constexpr double kSteadyDrive = 10.0;     // times that power, with the means: no wrong sign
constexpr double kSignErrors = 4.0;       // the same for the slope,
constexpr double kSignCorrelation = 0.2;  // with a correlation of at least this
constexpr int kMaxNoiseOrder = 60;

using Findings = std::vector<Finding>;

void Warn(const char* code, std::string sentence, Findings* findings) {
  findings->push_back({Severity::kWarning, code, std::move(sentence)});
}

void Note(const char* code, std::string sentence, Findings* findings) {
  findings->push_back({Severity::kNote, code, std::move(sentence)});
}

std::string PowerUnit(Dof dof, const std::string& force_unit) {
  return force_unit == ForceUnit(dof) ? "W" : fmt::format("{} {}", force_unit, VelocityUnit(dof));
}

// Velocity, mean force over the interval to the next stamp, and that interval, of all segments.
struct Samples {
  Eigen::ArrayXd force, velocity, step;
};

Samples SamplesOf(std::span<const Segment> segments) {
  Eigen::Index num_steps = 0;
  for (const Segment& segment : segments) {
    num_steps += std::max<Eigen::Index>(std::ssize(segment.time) - 1, 0);
  }
  Samples samples = {
      Eigen::ArrayXd(num_steps), Eigen::ArrayXd(num_steps), Eigen::ArrayXd(num_steps)};
  Eigen::Index row = 0;
  for (const Segment& segment : segments) {
    const std::vector<double> impulse = IntegralsOf(segment.command, segment.time).once;
    for (size_t i = 0; i + 1 < segment.time.size(); ++i, ++row) {
      const double h = segment.time[i + 1] - segment.time[i];
      samples.step[row] = h;
      samples.force[row] = (impulse[i + 1] - impulse[i]) / h;
      samples.velocity[row] = 0.5 * (segment.velocity[i] + segment.velocity[i + 1]);
    }
  }
  return samples;
}

// The power of the fluctuations, docs/findings.md (1): a constant force (buoyancy) takes no part.
void CheckPassivity(const Samples& samples, const std::string& unit, Findings* findings) {
  const double duration = samples.step.sum();
  const double mean_force = (samples.force * samples.step).sum() / duration;
  const double mean_velocity = (samples.velocity * samples.step).sum() / duration;
  const Eigen::ArrayXd power = (samples.force - mean_force) * (samples.velocity - mean_velocity);
  const double mean = (power * samples.step).sum() / duration;
  const double error = ErrorOfMean(power);
  if (!(mean < -kPowerErrors * error)) return;
  const double total = (samples.force * samples.velocity * samples.step).sum() / duration;
  const std::string what =
      fmt::format("The mean power of force times velocity, each about its mean, is {:.3g} {} ± {}.",
                  mean,
                  unit,
                  ShortNumber(kStdsOf95 * error, 1));
  if (total > kSteadyDrive * -mean) {
    Note("passivity",
         fmt::format("{} With the means it is {:.3g} {}: the force drives the vehicle, which is "
                     "slower where the force is larger. Turns and waves that slow it down do that, "
                     "and a propeller, which pushes more the slower it moves.",
                     what,
                     total,
                     unit),
         findings);
    return;
  }
  Warn("passivity",
       fmt::format("{} A passive vehicle cannot return energy. The cause may be a wrong sign or "
                   "frame, a delay of over a quarter period, or an external drive.",
                   what),
       findings);
}

// What the columns (v, v|v|, 1) leave of `values`.
Eigen::VectorXd WithoutVelocity(const Eigen::VectorXd& v, const Eigen::VectorXd& values) {
  const double fastest = std::max(v.lpNorm<Eigen::Infinity>(), 1e-300);
  const auto columns = [&](Eigen::Index i) {
    const double x = v[i] / fastest;
    return Eigen::Vector3d(x, x * std::abs(x), 1.0);
  };
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    const Eigen::Vector3d row = columns(i);
    gram += row * row.transpose();
    right += values[i] * row;
  }
  const Eigen::Vector3d solution = LeastSquares(gram, right);
  Eigen::VectorXd rest = values;
  for (Eigen::Index i = 0; i < v.size(); ++i) rest[i] -= columns(i).dot(solution);
  return rest;
}

// At equal velocity, acceleration against force; docs/findings.md (2).
void CheckForceSign(std::span<const Segment> segments, Findings* findings) {
  std::vector<double> rows[3];
  for (const Segment& segment : segments) {
    for (size_t i = 0; i < segment.acceleration.size(); ++i) {
      const double a = segment.acceleration[i];
      const double v = segment.smoothed_velocity[i], force = segment.smoothed_force[i];
      if (!std::isfinite(a) || !std::isfinite(v) || !std::isfinite(force)) continue;
      rows[0].push_back(a);
      rows[1].push_back(v);
      rows[2].push_back(force);
    }
  }
  const auto n = static_cast<Eigen::Index>(rows[0].size());
  if (n < 30) return;
  const auto column = [&](int k) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(rows[k].data(), n));
  };
  const Eigen::VectorXd v = column(1);
  const Eigen::VectorXd a = WithoutVelocity(v, column(0)), force = WithoutVelocity(v, column(2));
  if (!(a.squaredNorm() > 0.0 && force.squaredNorm() > 0.0)) return;
  const double correlation = a.dot(force) / (a.norm() * force.norm());
  if (correlation > -kSignCorrelation) return;
  const double slope = a.dot(force) / force.squaredNorm();
  const Eigen::VectorXd residual = a - slope * force;
  ColouredGram coloured(FitAutoregression({{residual.begin(), residual.end()}},
                                          std::min(kMaxNoiseOrder, static_cast<int>(n / 10))),
                        1);
  coloured.Add(force);
  const double error = std::sqrt(coloured.EndPiece()(0, 0)) / force.squaredNorm();
  if (slope > -kSignErrors * error) return;
  Warn("force_sign",
       fmt::format("At equal velocity a positive force decelerates the vehicle: acceleration "
                   "over force is {} ± {} (correlation {:.2f}). Check the sign of the "
                   "force and the clocks.",
                   ShortNumber(slope, 2),
                   ShortNumber(kStdsOf95 * error, 1),
                   correlation),
       findings);
}

// True if any command differs from the first. (Means over intervals would differ by rounding.)
bool Varies(std::span<const Segment> segments) {
  std::optional<double> first;
  for (const Segment& segment : segments) {
    for (const double value : segment.command.value) {
      if (!first) first = value;
      if (value != *first) return true;
    }
  }
  return false;
}

// Stamps that a link wrote as it delivered: several at once, then none for a while.
std::optional<Finding> CheckBatches(const Eigen::ArrayXd& step) {
  constexpr double kShort = 0.5, kLong = 2.0;             // of the mean step
  constexpr double kShareShort = 0.3, kShareLong = 0.08;  // of all steps
  const double n = static_cast<double>(step.size()), mean = step.mean();
  const auto num_short = static_cast<double>((step < kShort * mean).count());
  const auto num_long = static_cast<double>((step > kLong * mean).count());
  if (num_short < kShareShort * n || num_long < kShareLong * n) return std::nullopt;
  return Finding{
      Severity::kWarning,
      "arrival_stamps",
      fmt::format("The motion's stamps come in batches: {:.0f} % of the steps are under half the "
                  "mean of {:.3g} s, {:.0f} % over twice it, the longest {:.3g} s. They look like "
                  "times of arrival over a link.",
                  100.0 * num_short / n,
                  mean,
                  100.0 * num_long / n,
                  step.maxCoeff())};
}

void CheckStamps(const Samples& samples, Findings* findings) {
  const double median = Median({samples.step.begin(), samples.step.end()});
  if (median < kShortestStep || median > kLongestStep) {
    Warn("sampling_rate",
         fmt::format("The median step of the motion's stamps is {:.3g} s, expected {:g} s to {:g} "
                     "s. Are the stamps in seconds?",
                     median,
                     kShortestStep,
                     kLongestStep),
         findings);
  }
  if (auto batches = CheckBatches(samples.step)) {
    findings->push_back(*std::move(batches));
    return;
  }
  const Eigen::ArrayXd ratio = samples.step / median;
  const auto num_odd = ((ratio - 1.0).abs() > kJitter).count();
  const auto num_gaps = (ratio > kGap).count();
  if (num_odd > 0) {
    Note("jitter",
         fmt::format("{} of {} steps differ by over {:.0f} % from the median step of {:.3g} s.",
                     num_odd,
                     samples.step.size(),
                     100.0 * kJitter,
                     median),
         findings);
  }
  if (num_gaps > 0) {
    Note("gap",
         fmt::format("{} of over {:g} steps, the longest of {:.3g} s.",
                     Plural(static_cast<std::size_t>(num_gaps), "gap"),
                     kGap,
                     samples.step.maxCoeff()),
         findings);
  }
}

// The shaft of a motor on a bench may well turn faster than any vehicle.
void CheckSpeed(double fastest, Dof dof, Findings* findings) {
  if (!(fastest > kHighestSpeed)) return;
  if (IsAngular(dof)) {
    Note(
        "speed_range",
        fmt::format("The speed reaches {:.3g} rad/s. A vehicle does not turn at over {:g}: if this "
                    "is one, is the speed in deg/s?",
                    fastest,
                    kHighestSpeed),
        findings);
  } else {
    Warn("speed_range",
         fmt::format("The speed reaches {:.3g} m/s, expected at most {:g}. Is it in m/s?",
                     fastest,
                     kHighestSpeed),
         findings);
  }
}

}  // namespace

std::vector<Finding> CheckSignals(std::span<const Segment> segments,
                                  Dof dof,
                                  const std::string& force_unit) {
  Findings findings;
  const Samples samples = SamplesOf(segments);
  if (samples.step.size() < 2) return findings;
  CheckSpeed(samples.velocity.abs().maxCoeff(), dof, &findings);
  const bool force_varies = Varies(segments);
  const bool velocity_varies = samples.velocity.maxCoeff() > samples.velocity.minCoeff();
  if (!force_varies) {
    Warn("constant_command",
         fmt::format("The force is constant at {:.4g} {}. The log cannot determine a model.",
                     samples.force[0],
                     force_unit),
         &findings);
  }
  if (!velocity_varies) {
    Warn("constant_velocity",
         fmt::format("The velocity is constant at {:.4g} {}. The log cannot determine a model.",
                     samples.velocity[0],
                     VelocityUnit(dof)),
         &findings);
  }
  // In another unit they may well be pulse widths.
  if (force_unit == ForceUnit(dof)) {
    if (auto finding = CheckPulseWidths(segments)) findings.push_back(*std::move(finding));
  }
  if (force_varies && velocity_varies) {
    CheckPassivity(samples, PowerUnit(dof, force_unit), &findings);
    CheckForceSign(segments, &findings);
  }
  CheckStamps(samples, &findings);
  return findings;
}

}  // namespace fathom
