// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/sensors/measured_streams.h"

#include "fathom/base/random_stream.h"
#include "fathom/synthesize/experiment/correlated_noise.h"
#include "fathom/synthesize/experiment/resolution.h"
#include "fathom/synthesize/sensors/sampling.h"
#include "fathom/synthesize/sensors/shown_velocity.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace fathom {
namespace {

void AddRow(Stream& stream, double stamp, const std::vector<double>& row) {
  stream.time.push_back(stamp);
  for (std::size_t column = 0; column < row.size(); ++column) {
    stream.values[column].push_back(row[column]);
  }
}

void RemarkOnDropOuts(const SampleTimes& samples, const char* file, Log& log) {
  if (samples.num_drop_outs == 0) return;
  log.remarks.push_back({RemarkKind::kGeneral,
                         fmt::format("{}: {} drop-outs took {} of {} samples.",
                                     file,
                                     samples.num_drop_outs,
                                     samples.num_lost,
                                     samples.time.size())});
}

// What is added to the numbers of a sample that is an outlier, in standard deviations; 0 else.
class OutlierSource {
 public:
  OutlierSource(double probability, RandomStream random)
      : probability_(probability), random_(random) {}

  void NextSample() { is_outlier_ = probability_ > 0.0 && random_.Uniform() < probability_; }

  double Normal() { return is_outlier_ ? random_.Normal() : 0.0; }

 private:
  double probability_;
  RandomStream random_;
  bool is_outlier_ = false;
};

template <typename Source>
Eigen::Vector3d Normal3(Source& source) {
  Eigen::Vector3d vector;
  for (double& number : vector) number = source.Normal();
  return vector;
}

// How much later than the truth the poses are stamped [s].
double PoseDelay(const VehicleMotion& motion) {
  double delay = 0.0;
  for (const Dof dof : kAllDofs) delay += motion.hidden(dof).PoseDelay();
  return delay;
}

// What the poses show of where the vehicle is, along and about each driven DOF.
MotionState ShownPose(const VehicleMotion& motion,
                      MotionState state,
                      const HeldForces& held,
                      double t,
                      const std::vector<Drive>& drives) {
  const Surroundings now = {t, state.velocity, held.sent};
  for (const Drive& drive : drives) {
    const HiddenEffects& hidden = motion.hidden(drive.dof);
    const auto shown = [&](double displacement) {
      return hidden.Displacement(displacement, InstantsOf(hidden, now));
    };
    const int i = Index(drive.dof);
    if (!IsAngular(drive.dof)) {
      state.body_in_world[i] = shown(state.body_in_world[i]);
      continue;
    }
    const double turn = shown(state.travel[i]) - state.travel[i];
    if (turn == 0.0) continue;
    const Eigen::Map<Eigen::Quaterniond> world_from_body(state.world_from_body.data());
    const Eigen::Quaterniond turned(Eigen::Quaterniond(world_from_body) *
                                    Eigen::AngleAxisd(turn, Eigen::Vector3d::Unit(i - 3)));
    state.world_from_body = turned.coeffs();
  }
  return state;
}

}  // namespace

Stream CommandStream(const TrueRun& truth, const Experiment& experiment) {
  Stream stream;
  for (const Drive& drive : experiment.drives) stream.columns.emplace_back(ForceColumn(drive.dof));
  stream.values.resize(stream.columns.size());
  for (std::size_t k = 0; k < truth.command_time.size(); ++k) {
    std::vector<double> row;
    for (const Drive& drive : experiment.drives) row.push_back(truth.command[k][Index(drive.dof)]);
    AddRow(stream, RoundTo(experiment.start_time + truth.command_time[k], kStampResolution), row);
  }
  return stream;
}

Stream VelocityStream(const VehicleMotion& motion,
                      const TrueRun& truth,
                      const Experiment& experiment,
                      std::uint64_t seed,
                      Log& log) {
  const VelocitySensor& sensor = *experiment.velocity;
  const SampleTimes samples =
      DrawSampleTimes(sensor.sampling, experiment.duration, seed, "velocity");
  RemarkOnDropOuts(samples, "velocity.csv", log);
  Stream stream;
  std::vector<CorrelatedNoise> noise;
  for (const Drive& drive : experiment.drives) {
    stream.columns.emplace_back(VelocityColumn(drive.dof));
    noise.emplace_back(RandomStream(seed, "velocity.noise." + std::string(Name(drive.dof))),
                       sensor.noise_correlation);
  }
  stream.values.resize(stream.columns.size());
  OutlierSource outliers(sensor.outlier_probability, RandomStream(seed, "velocity.outliers"));
  ShownVelocity shown(motion, truth);
  for (std::size_t k = 0; k < samples.time.size(); ++k) {
    const double t = samples.time[k];
    const std::array<double, 6> velocity = shown.At(t);
    outliers.NextSample();
    std::vector<double> row;  // of lost samples too: noise goes on underneath
    for (std::size_t i = 0; i < experiment.drives.size(); ++i) {
      const int dof = Index(experiment.drives[i].dof);
      const double measured = velocity[dof] + sensor.noise[dof] * noise[i].Next() +
                              sensor.outlier_size[dof] * outliers.Normal();
      row.push_back(RoundTo(measured, sensor.resolution));
    }
    if (!samples.has_arrived[k]) continue;
    AddRow(stream, RoundTo(experiment.start_time + t, kStampResolution), row);
  }
  return stream;
}

Stream PoseStream(const VehicleMotion& motion,
                  const TrueRun& truth,
                  const Experiment& experiment,
                  std::uint64_t seed,
                  Log& log) {
  const PoseSensor& sensor = *experiment.pose;
  const double delay = PoseDelay(motion);
  const SampleTimes samples = DrawSampleTimes(sensor.sampling, experiment.duration, seed, "pose");
  RemarkOnDropOuts(samples, "pose.csv", log);
  RandomStream position_noise(seed, "pose.noise.position");
  RandomStream angle_noise(seed, "pose.noise.angle");
  OutlierSource outliers(sensor.outlier_probability, RandomStream(seed, "pose.outliers"));
  Stream stream;
  stream.columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  stream.values.resize(stream.columns.size());
  std::size_t place = 0;
  for (std::size_t k = 0; k < samples.time.size(); ++k) {
    const double t = samples.time[k];
    place = truth.Before(t, place);
    const MotionState state =
        ShownPose(motion, truth.StateAt(motion, place, t), truth.held[place], t, experiment.drives);
    outliers.NextSample();
    const Eigen::Vector3d p = state.body_in_world +
                              sensor.position_noise * Normal3(position_noise) +
                              sensor.outlier_position * Normal3(outliers);
    const Eigen::Vector3d turn =
        sensor.angle_noise * Normal3(angle_noise) + sensor.outlier_angle * Normal3(outliers);
    const double angle = turn.norm();
    const Eigen::Quaterniond body_from_measured(Eigen::AngleAxisd(
        angle, angle > 0.0 ? Eigen::Vector3d(turn / angle) : Eigen::Vector3d::UnitX()));
    const Eigen::Quaterniond q = Eigen::Quaterniond(state.world_from_body) * body_from_measured;
    if (!samples.has_arrived[k]) continue;
    std::vector<double> row = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
    for (double& number : row) number = RoundTo(number, sensor.resolution);
    AddRow(stream, RoundTo(experiment.start_time + t + delay, kStampResolution), row);
  }
  return stream;
}

}  // namespace fathom
