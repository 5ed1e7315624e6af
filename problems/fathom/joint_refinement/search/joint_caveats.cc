// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/joint_caveats.h"

#include "fathom/base/interval95.h"
#include "fathom/joint_refinement/motion/global_columns.h"
#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/output_error/caveats.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace fathom {
namespace {

double HalfWidth(double variance) { return kStdsOf95 * std::sqrt(variance); }  // of a 95 % interval

// How far the excited motion goes off the mean axis of its DOF [rad], by the slopes of the other
// translations' responses over it; 0 for an angle.
double AngleOffAxis(const JointStart& at, size_t segment) {
  const int excited = at.data.excited;
  if (excited >= 3) return 0.0;
  const PredictedMotion& motion = at.data.segments[segment].motion;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), products = Eigen::Vector3d::Zero();
  for (size_t k = 0; k < motion.size(); ++k) mean += motion.Mean(k).head<3>();
  mean /= static_cast<double>(motion.size());
  for (size_t k = 0; k < motion.size(); ++k) {
    const Eigen::Vector3d off = motion.Mean(k).head<3>() - mean;
    products += off[excited] * off;
  }
  Eigen::Vector3d slopes = products / products[excited];
  slopes[excited] = 0.0;
  return std::atan(slopes.norm());
}

std::string CaveatOnAxis(Dof dof, const JointStart& at, const JointSummary& summary) {
  double angle = 0.0;
  for (size_t r = 0; r < summary.segments.size(); ++r) angle = std::max(angle, AngleOffAxis(at, r));
  const double too_large = 1.0 / std::cos(angle) - 1.0;
  const double std = std::sqrt(summary.covariance(kInertia, kInertia)) / summary.model.inertia;
  if (!(too_large > 0.5 * std)) return "";
  return fmt::format(
      "The vehicle moves {:.1f} degrees off its mean {} axis. If mount or survey cause this and "
      "not the vehicle, inertia and linear damping are {:.2g} % too large, which is not small "
      "against the interval.",
      angle * 180.0 / std::numbers::pi,
      Name(dof),
      100.0 * too_large);
}

std::string CaveatOn(int damping, const JointSummary& summary) {
  const double variance = summary.covariance(damping, damping);
  if (summary.on_bound[damping]) return CaveatOnBound(damping, HalfWidth(variance));
  return CaveatOnDamping(damping, ToVector(summary.model)[damping], std::sqrt(variance));
}

// The linear problem about the search's end with the camera's clock free in these segments.
LinearJoint WithClockFree(const JointOptions& options,
                          const JointStart& at,
                          const SearchEnd& end,
                          std::span<const LinearSegment> linear,
                          size_t begin_segment,
                          size_t end_segment) {
  auto priors = PriorsOf(options, at.unknowns, {});
  for (size_t r = begin_segment; r < end_segment; ++r) {
    priors[r].std[kClockColumn] = std::numeric_limits<double>::infinity();
  }
  return {linear, priors, at.processes, at.data.excited, &end.setup.information};
}

// A delay of the command is an offset of the camera's clock: how well the model is known where
// that is free says how much hangs on it.
std::string CaveatOnDelayOf(const JointInput& input,
                            const JointOptions& options,
                            const JointStart& at,
                            const SearchEnd& end,
                            std::span<const LinearSegment> linear,
                            const JointSummary& summary) {
  if (options.clock_offset_std > 0.0) return "";  // the intervals have it in them
  const double inertia = summary.model.inertia;   // the column is of its logarithm
  DelayDoubt doubt = {.inertia = inertia,
                      .half_width = HalfWidth(summary.covariance(kInertia, kInertia)),
                      .half_width_with_delay = std::numeric_limits<double>::infinity()};
  if (const auto all = WithClockFree(options, at, end, linear, 0, linear.size()); all.is_usable()) {
    doubt.half_width_with_delay = inertia * HalfWidth(all.covariance(0)(kInertia, kInertia));
  }
  if (!(doubt.half_width < kLostToDelay * doubt.half_width_with_delay)) return "";
  // Linear: what the same delay in every segment changes is the sum over the segments.
  for (size_t r = 0; r < linear.size(); ++r) {
    const LinearJoint one = WithClockFree(options, at, end, linear, r, r + 1);
    if (!one.is_usable()) continue;
    const Eigen::MatrixXd& covariance = one.covariance(r);
    // What is commanded later is seen by a clock that is behind.
    const double per_second = -1.0 / covariance(kClockColumn, kClockColumn);
    doubt.inertia_per_second += per_second * inertia * covariance(kInertia, kClockColumn);
    doubt.linear_damping_per_second += per_second * covariance(kLinearDamping, kClockColumn);
  }
  const CameraSegment& longest =
      *std::max_element(input.segments.begin(),
                        input.segments.end(),
                        [](const CameraSegment& a, const CameraSegment& b) {
                          return a.time.back() - a.time.front() < b.time.back() - b.time.front();
                        });
  return CaveatOnDelay(longest.command.Between(longest.time.front(), longest.time.back()), doubt);
}

// That the camera's clock is not what the options hold it for: by where a step of the linear
// problem would take it. Of the segment that is the most certain.
std::string CaveatOnClock(const JointOptions& options,
                          const JointStart& at,
                          const SearchEnd& end,
                          std::span<const LinearSegment> linear) {
  if (options.clock_offset_std > 0.0) return "";
  const LinearJoint free = WithClockFree(options, at, end, linear, 0, linear.size());
  if (!free.is_usable()) return "";
  constexpr double kFarOff = 5.0;  // standard deviations
  double offset = 0.0, std = 1.0;
  for (size_t r = 0; r < linear.size(); ++r) {
    const double own = free.change(r)[kClockColumn];
    const double own_std = std::sqrt(free.covariance(r)(kClockColumn, kClockColumn));
    if (std::abs(own) / own_std > std::abs(offset) / std) offset = own, std = own_std;
  }
  if (!(std::abs(offset) > kFarOff * std)) return "";
  return fmt::format(
      "The corners contradict an exact camera clock: they suggest an offset of about {:.2g} s (± "
      "{:.1g} s). The parameters are then wrong by more than their intervals. Correct the stamps, "
      "or estimate the offset (--clock_offset_std=1).",
      offset,
      std);
}

}  // namespace

std::vector<std::string> CaveatsOn(const JointInput& input,
                                   const JointOptions& options,
                                   const JointStart& at,
                                   const SearchEnd& end,
                                   std::span<const LinearSegment> linear,
                                   const JointSummary& summary) {
  std::vector<std::string> caveats;
  if (!options.moves_freely) {
    caveats = {CaveatOn(kQuadraticDamping, summary),
               CaveatOn(kLinearDamping, summary),
               CaveatOnDelayOf(input, options, at, end, linear, summary),
               CaveatOnClock(options, at, end, linear)};
  }
  caveats.push_back(CaveatOnAxis(input.dof, at, summary));
  std::erase(caveats, "");
  if (!end.processes_settled) {
    caveats.push_back(
        "The estimate of how the held coordinates wander did not converge. The intervals are "
        "less certain than they look.");
  }
  if (!end.likelihood_settled) {
    caveats.push_back(
        fmt::format("The likelihood was still rising after {} rounds. The intervals are less "
                    "certain than they look.",
                    summary.num_rounds));
  }
  return caveats;
}

}  // namespace fathom
