// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/judge_dives.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quantile.h"
#include "fathom/ordinary_dives/dive_stretches.h"
#include "fathom/ordinary_dives/ordinary_knowledge.h"
#include "fathom/ordinary_dives/ordinary_remedies.h"
#include "fathom/ordinary_dives/run_noise.h"
#include "fathom/ordinary_dives/run_normal.h"
#include "fathom/planning/named_parameters.h"
#include "fathom/planning/plan_request.h"
#include "fathom/planning/segment_derivatives.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kMostChosen = 8;

// Of what all logs know, lent to a choice that does not yet determine all parameters: it orders
// choices by what they add, and is left out of what is printed.
constexpr double kLent = 1e-4;

constexpr double kLeastDamping = 0.01;  // share of the greatest force, at the greatest speed
constexpr double kUsualShare = 0.99;    // of the samples: outliers are no greatest force or speed

OrdinaryReach ReachOf(std::span<const Segment> segments) {
  std::vector<double> forces, speeds;
  for (const Segment& segment : segments) {
    for (const double force : segment.command.At(segment.time)) forces.push_back(std::abs(force));
    for (const double speed : segment.velocity) speeds.push_back(std::abs(speed));
  }
  return {Quantile(std::move(forces), kUsualShare), Quantile(std::move(speeds), kUsualShare)};
}

// Of those parameters that do not belong to one run: their places in the covariance.
std::vector<Eigen::Index> SharedPlaces(const ExtendedModel& model) {
  std::vector<Eigen::Index> places;
  const std::vector<bool> of_run = AreOfRun(model);
  for (std::size_t i = 0; i < of_run.size(); ++i) {
    if (!of_run[i]) places.push_back(static_cast<Eigen::Index>(i));
  }
  return places;
}

std::vector<OrdinaryParameter> SizedParameters(const FittedModel& model,
                                               const std::vector<Eigen::Index>& places,
                                               const OrdinaryReach& reach) {
  const std::vector<PlannedParameter> named = NamedParameters(model);
  std::vector<OrdinaryParameter> parameters;
  for (const Eigen::Index place : places) {
    const PlannedParameter& from = named[static_cast<std::size_t>(place)];
    OrdinaryParameter& parameter = parameters.emplace_back();
    parameter.name = from.name;
    parameter.unit = from.unit;
    parameter.value = from.value;
    parameter.by_fit = std::sqrt(model.covariance(place, place));
    double least = 0.0;
    if (place == kQuadraticDamping) least = kLeastDamping * reach.force / std::pow(reach.speed, 2);
    if (place == kLinearDamping) least = kLeastDamping * reach.force / reach.speed;
    if (place == kBuoyancy) least = reach.force;
    parameter.size = std::max(std::abs(from.value), least);
  }
  return parameters;
}

// The runs of the model over segments; a message where one diverges.
std::vector<SegmentRun> RunsOver(const OrdinaryRequest& request) {
  std::vector<SegmentRun> runs;
  for (std::size_t s = 0; s < request.segments.size(); ++s) {
    auto run = RunOver(request.segments[s], request.model.Extended(), request.model.dof);
    if (!run) {
      throw InputError(
          fmt::format("--log: {} diverges over {} from t = {:g} s, expected a model of the same "
                      "vehicle.",
                      request.name,
                      request.logs[request.log_of_segment[s]],
                      request.segments[s].time.front()));
    }
    runs.push_back(*std::move(run));
  }
  return runs;
}

RunNoise NoiseOver(const OrdinaryRequest& request, const std::vector<SegmentRun>& runs) {
  const bool is_position = std::ranges::none_of(
      request.segments, [](const Segment& segment) { return segment.position.empty(); });
  std::vector<ComparedSegment> compared;
  for (std::size_t s = 0; s < runs.size(); ++s) {
    const MotionDerivatives& derivatives = runs[s].derivatives;
    compared.push_back({&request.segments[s],
                        is_position ? runs[s].motion.displacement : runs[s].motion.velocity,
                        is_position ? &derivatives.displacement_by_start : &derivatives.by_start});
  }
  const RunNoise noise = NoiseOfRuns(compared, is_position);
  if (noise.noise.velocity > 0.0) return noise;
  throw InputError(fmt::format(
      "--log: {} misses nothing of these logs, expected noise, by which intervals are told.",
      request.name));
}

// The next stretch that leaves the weakest parameter best known beside those so far; beyond all if
// none is left.
std::size_t BestNext(const std::vector<OrdinaryStretch>& stretches,
                     const std::vector<RunNormal>& normals,
                     const RunNormal& so_far,
                     const std::vector<OrdinaryParameter>& parameters) {
  std::size_t best = stretches.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    if (stretches[k].place > 0) continue;
    RunNormal with_it = so_far;
    with_it.Add(normals[k]);
    const double share = KnowledgeBy(with_it.Information(), parameters).share;
    if (!(share < least)) continue;
    least = share;
    best = k;
  }
  return best;
}

// docs/plan.md, "Ordinary dives": one stretch after the other until they do.
void ChooseStretches(const std::vector<RunNormal>& normals,
                     const RunNormal& of_all,
                     OrdinaryDives* dives) {
  RunNormal sum = RunNormal::Zero(of_all.A.rows());
  while (dives->chosen.size() < kMostChosen) {
    RunNormal lent = sum;
    lent.Add(of_all, kLent);
    const std::size_t next = BestNext(dives->stretches, normals, lent, dives->parameters);
    if (next == dives->stretches.size()) return;
    sum.Add(normals[next]);
    dives->chosen.push_back(next);
    OrdinaryStretch& stretch = dives->stretches[next];
    stretch.place = static_cast<int>(dives->chosen.size());
    stretch.together = KnowledgeBy(sum.Information(), dives->parameters);
    if (dives->DoesAsWellAsAll(stretch.together)) return;
  }
}

}  // namespace

OrdinaryDives JudgeDives(const OrdinaryRequest& request) {
  const ExtendedModel model = request.model.Extended();
  const Dof dof = request.model.dof;
  RequireOwnEffects(model, dof, request.name);
  const std::vector<Eigen::Index> places = SharedPlaces(model);
  const OrdinaryReach reach = ReachOf(request.segments);
  const std::vector<SegmentRun> runs = RunsOver(request);
  const RunNoise noise = NoiseOver(request, runs);

  OrdinaryDives dives;
  dives.parameters = SizedParameters(request.model, places, reach);
  dives.is_position = noise.is_position;
  dives.noise = noise.noise.velocity;
  dives.neighbour_correlation = noise.NeighbourCorrelation();
  std::size_t num_samples = 0;
  for (const Segment& segment : request.segments) {
    dives.duration += segment.time.back() - segment.time.front();
    num_samples += segment.time.size() - 1;
  }
  dives.rate = static_cast<double>(num_samples) / dives.duration;

  RunNormal of_all = RunNormal::Zero(std::ssize(places));
  for (std::size_t s = 0; s < runs.size(); ++s) {
    of_all.Add(NormalOfRun(runs[s].derivatives, request.segments[s].time, places, noise));
  }
  dives.all = KnowledgeBy(of_all.Information(), dives.parameters);
  if (std::isinf(dives.all.share)) {
    dives.message =
        "The logs together do not tell all parameters: no stretch of them will. Give a log in "
        "which the vehicle is driven along this DOF.";
    return dives;
  }
  dives.message.clear();
  for (std::size_t i = 0; i < places.size(); ++i) dives.parameters[i].by_all = dives.all.stds[i];

  std::vector<RunNormal> normals;
  for (const DiveStretch& part : CutAtNaturalEnds(request.segments)) {
    const Segment segment = SegmentOfStretch(part, request.segments);
    const auto run = RunOver(segment, model, dof);
    normals.push_back(run ? NormalOfRun(run->derivatives, segment.time, places, noise)
                          : RunNormal::Zero(std::ssize(places)));
    OrdinaryStretch& stretch = dives.stretches.emplace_back();
    stretch.stretch = part;
    stretch.log_index = request.log_of_segment[part.segment_index];
    stretch.time = TimeOf(part, request.segments);
    stretch.alone = KnowledgeBy(normals.back().Information(), dives.parameters);
  }
  ChooseStretches(normals, of_all, &dives);
  dives.remedies = RemediesFor({request, dives, places, reach, noise, of_all, runs});
  return dives;
}

}  // namespace fathom
