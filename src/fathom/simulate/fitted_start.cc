// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/fitted_start.h"

#include "fathom/base/robust_std.h"
#include "fathom/simulate/effect_simulation.h"
#include "fathom/simulate/run_start.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kStart = 2.0;          // [s]
constexpr std::ptrdiff_t kFewest = 10;  // samples of the same

// The first seconds of a stretch.
struct FirstSeconds {
  OutputStamps stamps;
  std::vector<double> velocity, displacement;
};

// With ten samples at least.
FirstSeconds FirstSecondsOf(const MeasuredMotion& motion) {
  FirstSeconds first;
  first.stamps.start = motion.start;
  const auto take = [&](std::span<const double> all_stamps,
                        std::span<const double> all_values,
                        std::vector<double>* time,
                        std::vector<double>* value) {
    const auto end = std::ranges::upper_bound(all_stamps, motion.start + kStart);
    const std::ptrdiff_t count =
        std::max(end - all_stamps.begin(), std::min(std::ssize(all_stamps), kFewest));
    time->assign(all_stamps.begin(), all_stamps.begin() + count);
    value->assign(all_values.begin(), all_values.begin() + count);
  };
  take(motion.velocity_time, motion.velocity, &first.stamps.velocity, &first.velocity);
  take(motion.displacement_time,
       motion.displacement,
       &first.stamps.displacement,
       &first.displacement);
  return first;
}

InitialState GuessOf(const FirstSeconds& first, double position) {
  InitialState guess;
  guess.position = position;
  if (!first.displacement.empty()) {
    const Line line =
        LineThrough(first.stamps.start, first.stamps.displacement, first.displacement);
    guess.position = line.value;
    guess.velocity = line.slope;
  }
  if (!first.velocity.empty()) {
    guess.velocity = LineThrough(first.stamps.start, first.stamps.velocity, first.velocity).value;
  }
  return guess;
}

// Takes out what is far from what a run shows, as a single wrong sample among a few is.
void TakeOutOutliers(const std::vector<double>& shown,
                     std::vector<double>* time,
                     std::vector<double>* value) {
  constexpr double kFar = 5.0;  // robust standard deviations
  std::vector<double> miss;
  for (size_t i = 0; i < value->size(); ++i) miss.push_back(std::abs((*value)[i] - shown[i]));
  if (miss.empty()) return;
  const double far = kFar * RobustStd(miss);
  size_t kept = 0;
  for (size_t i = 0; i < miss.size(); ++i) {
    if (miss[i] > far) continue;
    (*time)[kept] = (*time)[i];
    (*value)[kept++] = (*value)[i];
  }
  if (kept < 3) return;
  time->resize(kept);
  value->resize(kept);
}

// The state at the start that the first seconds tell: the speed, the place where it is measured,
// and what a sensor with a memory shows. (What the water remembers comes from what was measured
// before; two seconds would tell it badly.)
struct StartUnknown {
  double InitialState::*value;
  Eigen::Index column;  // in a run's sensitivities
};

std::vector<StartUnknown> StartUnknownsOf(const FirstSeconds& first, const ExtendedModel& model) {
  std::vector<StartUnknown> unknowns = {
      {&InitialState::velocity, EffectSimulation::kInitialVelocityColumn}};
  if (!first.displacement.empty()) {
    unknowns.push_back({&InitialState::position, EffectSimulation::kInitialPositionColumn});
  }
  const std::vector<Excess> excesses = EffectSimulation::ExcessesOf(model);
  Eigen::Index column = EffectSimulation::NumColumns(model) - std::ssize(excesses);
  for (const Excess excess : excesses) {
    if (excess == &InitialState::reading_excess) unknowns.push_back({excess, column});
    ++column;
  }
  return unknowns;
}

// A least-squares step of the state at the start, and the error there.
struct StartStep {
  Eigen::VectorXd change;  // of StartUnknownsOf()
  double squared_error = 0.0;
};

// Velocities, where they are measured, tell the speed, and displacements the place: these weigh
// next to nothing beside them.
StartStep StepTowards(const FirstSeconds& first,
                      const EffectOutputs& outputs,
                      const std::vector<StartUnknown>& unknowns) {
  constexpr double kWeightOfPlace = 1e-6;
  const auto num_velocities = static_cast<Eigen::Index>(outputs.velocity.size());
  const auto num_displacements = static_cast<Eigen::Index>(outputs.displacement.size());
  Eigen::MatrixXd rows(num_velocities + num_displacements, std::ssize(unknowns));
  Eigen::VectorXd miss(rows.rows());
  for (Eigen::Index j = 0; j < rows.cols(); ++j) {
    rows.col(j).head(num_velocities) = outputs.velocity_sensitivity.col(unknowns[j].column);
    rows.col(j).tail(num_displacements) = outputs.displacement_sensitivity.col(unknowns[j].column);
  }
  for (Eigen::Index i = 0; i < num_velocities; ++i) {
    miss[i] = first.velocity[i] - outputs.velocity[i];
  }
  for (Eigen::Index i = 0; i < num_displacements; ++i) {
    miss[num_velocities + i] = first.displacement[i] - outputs.displacement[i];
  }
  if (num_velocities > 0) {
    rows.bottomRows(num_displacements) *= kWeightOfPlace;
    miss.tail(num_displacements) *= kWeightOfPlace;
  }
  return {LeastSquares(rows, miss), miss.squaredNorm()};
}

InitialState Moved(InitialState state,
                   const std::vector<StartUnknown>& unknowns,
                   const Eigen::VectorXd& change) {
  for (size_t i = 0; i < unknowns.size(); ++i) {
    state.*unknowns[i].value += change[static_cast<Eigen::Index>(i)];
  }
  return state;
}

// The best state and what the run from it shows.
struct Fitted {
  InitialState state;
  EffectOutputs outputs;
};

std::optional<Fitted> FitStart(const FirstSeconds& first,
                               const ExtendedModel& model,
                               const EffectInputs& inputs,
                               const InitialState& guess) {
  constexpr int kMostSteps = 6;
  const EffectSimulation simulation(&inputs, first.stamps);
  const std::vector<StartUnknown> unknowns = StartUnknownsOf(first, model);
  Fitted best = {guess, {}};
  if (!simulation.RunWithSensitivities(model, guess, &best.outputs)) return std::nullopt;
  StartStep step = StepTowards(first, best.outputs, unknowns);
  double share = 1.0;
  for (int i = 0; i < kMostSteps; ++i) {
    Fitted next = {Moved(best.state, unknowns, share * step.change), {}};
    const bool runs = simulation.RunWithSensitivities(model, next.state, &next.outputs);
    const StartStep on = runs ? StepTowards(first, next.outputs, unknowns) : StartStep{};
    if (!runs || !(on.squared_error < step.squared_error)) {
      share *= 0.3;
      continue;
    }
    const bool has_arrived = on.squared_error > 0.999 * step.squared_error;
    best = std::move(next);
    step = on;
    share = 1.0;
    if (has_arrived) break;
  }
  return best;
}

}  // namespace

MeasuredMotion MotionOf(const Segment& segment) {
  MeasuredMotion motion;
  motion.start = segment.time.front();
  if (segment.position.empty()) {
    motion.velocity_time = segment.time;
    motion.velocity = segment.velocity;
  } else {
    motion.displacement_time = segment.time;
    motion.displacement = segment.position;
  }
  return motion;
}

std::optional<InitialState> FittedStart(const ExtendedModel& model,
                                        const EffectInputs& inputs,
                                        const MeasuredMotion& motion,
                                        double position) {
  FirstSeconds first = FirstSecondsOf(motion);
  const auto rough = FitStart(first, model, inputs, GuessOf(first, position));
  if (!rough) return std::nullopt;
  TakeOutOutliers(rough->outputs.velocity, &first.stamps.velocity, &first.velocity);
  TakeOutOutliers(rough->outputs.displacement, &first.stamps.displacement, &first.displacement);
  const auto fitted = FitStart(first, model, inputs, rough->state);
  return fitted ? fitted->state : rough->state;
}

}  // namespace fathom
