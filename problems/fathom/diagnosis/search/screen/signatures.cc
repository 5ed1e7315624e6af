// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/signatures.h"

#include "fathom/base/parallel_for.h"
#include "fathom/simulate/mean_thruster_forces.h"
#include "fathom/vehicle/effect_law.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace fathom {
namespace {

using Law = EffectLaw<double>;

// Whether an effect acts on the thrusters' force alone, whatever the speed.
bool IsForceOfThrusters(const Effect& effect) {
  return effect.info().place == Place::kActuator && !effect.law<double>().thrust_at_speed;
}

// Whether an effect changes what poses show of where the vehicle is, and nothing else.
bool IsShownByPosesAlone(const Effect& effect) {
  const Law& law = effect.law<double>();
  return law.displacement && !law.reading && !law.both_readings && !law.pose_delay &&
         !effect.info().has_partner();
}

// The parameter values of a trial with only one of its amounts at its probe.
std::vector<double> WithOneAmount(const Trial& trial, const EffectInfo& info, int amount) {
  std::vector<double> values = trial.values;
  for (const int other : trial.amounts) {
    if (other != amount) values[other] = info.parameters[other].null;
  }
  return values;
}

// What signatures are made of: a fitted model and its run.
class Signatures {
 public:
  Signatures(const TrainingData& data, const ForceResponse& response, const StructureFit& fit)
      : data_(data),
        response_(response),
        fit_(fit),
        base_(data.Simulate(fit.model, fit.initial)),
        acts_at_speed_(std::any_of(
            fit.model.effects.begin(), fit.model.effects.end(), [](const ActiveEffect& active) {
              return active.effect->law<double>().thrust_at_speed;
            })) {
    for (const RunPoint& point : response.points()) times_.push_back(point.time);
    if (!acts_at_speed_) force_ = ThrusterForces(fit.model);
  }

  Eigen::VectorXd Of(const ActiveEffect& active) const {
    if (IsForceInWater(*active.effect)) {
      return response_.Outputs(
          ForceAlong(response_.points(), data_.segments(), fit_.model.baseline, active));
    }
    if (!acts_at_speed_ && IsForceOfThrusters(*active.effect)) return OfThrusters(active);
    if (IsShownByPosesAlone(*active.effect)) return OfPoses(active);
    const auto simulated =
        base_ ? data_.SimulateLog(
                    active.setting.log, WithEffect(fit_.model, active), fit_.initial, *base_)
              : std::nullopt;
    if (!simulated) return Eigen::VectorXd::Zero(data_.bins().size());
    return *simulated - *base_;
  }

 private:
  // Mean over the step that ends at each point.
  std::vector<double> ThrusterForces(const ExtendedModel& model) const {
    std::vector<double> forces(times_.size(), 0.0);
    for (std::size_t r = 0; r < data_.segments().size(); ++r) {
      const auto first = static_cast<std::size_t>(response_.first_point(r));
      const auto end = static_cast<std::size_t>(response_.first_point(r + 1));
      const auto means = MeanThrusterForces(
          *data_.segments()[r].inputs, model, std::span(times_).subspan(first, end - first));
      std::copy(means.begin(), means.end(), forces.begin() + first + 1);
    }
    return forces;
  }

  Eigen::VectorXd OfThrusters(const ActiveEffect& active) const {
    std::vector<double> more = ThrusterForces(WithEffect(fit_.model, active));
    for (std::size_t i = 0; i < more.size(); ++i) more[i] -= force_[i];
    return response_.OutputsOfMeans(more);
  }

  Eigen::VectorXd OfPoses(const ActiveEffect& active) const {
    Eigen::VectorXd shown = Eigen::VectorXd::Zero(data_.bins().size());
    for (std::size_t r = 0; r < data_.segments().size(); ++r) {
      const MeasuredSegment& segment = data_.segments()[r];
      if (!active.setting.ActsIn(segment.log)) continue;
      const std::vector<double> velocity(segment.stamps.velocity.size(), 0.0);
      std::vector<double> displacement;
      std::size_t point = response_.first_point(r);
      const std::size_t last = response_.first_point(r + 1) - 1;
      for (const double stamp : segment.stamps.displacement) {
        while (point + 1 < last && times_[point + 1] < stamp) ++point;
        displacement.push_back(MoreShown(active, r, point, stamp));
      }
      const int first = data_.bins().first_row(r);
      data_.bins().Average(r,
                           velocity,
                           displacement,
                           std::span(shown.data() + first, data_.bins().first_row(r + 1) - first));
    }
    return shown;
  }

  // At a stamp of segment `r` between a point and the next.
  double MoreShown(const ActiveEffect& active,
                   std::size_t r,
                   std::size_t point,
                   double stamp) const {
    const std::vector<RunPoint>& points = response_.points();
    const RunPoint& before = points[point];
    const std::size_t next = std::min(point + 1, points.size() - 1);
    const double step = times_[next] - before.time;
    const double share = step > 0.0 ? (stamp - before.time) / step : 0.0;
    const double from_start = before.position + share * (points[next].position - before.position) -
                              fit_.initial[r].position;
    Instant<double> now;
    now.time = stamp - data_.segments()[r].inputs->command.time.front();
    return active.effect->law<double>().displacement(active.values.data(), from_start, now) -
           from_start;
  }

  const TrainingData& data_;
  const ForceResponse& response_;
  const StructureFit& fit_;
  const std::optional<Eigen::VectorXd> base_;
  const bool acts_at_speed_;
  std::vector<double> times_;  // of the points [s]
  std::vector<double> force_;  // of the fitted model's thrusters
};

}  // namespace

RowMajorMatrix SignaturesOf(const TrainingData& data,
                            const ForceResponse& response,
                            const StructureFit& fit,
                            const std::vector<Suspect>& suspects,
                            std::span<const Trial> trials) {
  const int num_columns =
      trials.empty() ? 0 : trials.back().first_column + trials.back().num_columns;
  RowMajorMatrix columns = RowMajorMatrix::Zero(data.bins().size(), num_columns);
  const Signatures signatures(data, response, fit);
  ParallelFor(static_cast<int>(trials.size()), [&](int i) {
    const Trial& trial = trials[i];
    const Suspect& suspect = suspects[trial.suspect];
    for (int k = 0; k < trial.num_columns; ++k) {
      const auto values = WithOneAmount(trial, suspect.effect->info(), trial.amounts[k]);
      columns.col(trial.first_column + k) =
          signatures.Of({suspect.effect, suspect.setting, values});
    }
  });
  return columns;
}

}  // namespace fathom
