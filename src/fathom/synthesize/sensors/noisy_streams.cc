// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/sensors/noisy_streams.h"

#include "fathom/base/random_stream.h"
#include "fathom/synthesize/experiment/correlated_noise.h"
#include "fathom/synthesize/experiment/resolution.h"
#include "fathom/synthesize/sensors/sampling.h"

#include <string>

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

SampleTimes VelocitySamples(const Experiment& experiment, std::uint64_t seed) {
  return DrawSampleTimes(experiment.velocity->sampling, experiment.duration, seed, "velocity");
}

SampleTimes PoseSamples(const Experiment& experiment, std::uint64_t seed) {
  return DrawSampleTimes(experiment.pose->sampling, experiment.duration, seed, "pose");
}

}  // namespace

std::vector<double> VelocityTimes(const Experiment& experiment, std::uint64_t seed) {
  return VelocitySamples(experiment, seed).time;
}

std::vector<double> PoseTimes(const Experiment& experiment, std::uint64_t seed) {
  return PoseSamples(experiment, seed).time;
}

Stream NoisyVelocities(const std::vector<Dof>& dofs,
                       const VelocityShown& shown,
                       const Experiment& experiment,
                       std::uint64_t seed,
                       Log& log) {
  const VelocitySensor& sensor = *experiment.velocity;
  const SampleTimes samples = VelocitySamples(experiment, seed);
  RemarkOnDropOuts(samples, "velocity.csv", log);
  Stream stream;
  std::vector<CorrelatedNoise> noise;
  for (const Dof dof : dofs) {
    stream.columns.emplace_back(VelocityColumn(dof));
    noise.emplace_back(RandomStream(seed, "velocity.noise." + std::string(Name(dof))),
                       sensor.noise_correlation);
  }
  stream.values.resize(stream.columns.size());
  OutlierSource outliers(sensor.outlier_probability, RandomStream(seed, "velocity.outliers"));
  for (std::size_t k = 0; k < samples.time.size(); ++k) {
    const double t = samples.time[k];
    const std::array<double, 6> velocity = shown(k, t);
    outliers.NextSample();
    std::vector<double> row;  // of lost samples too: noise goes on underneath
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      const int dof = Index(dofs[i]);
      const double measured = velocity[dof] + sensor.noise[dof] * noise[i].Next() +
                              sensor.outlier_size[dof] * outliers.Normal();
      row.push_back(RoundTo(measured, sensor.resolution));
    }
    if (!samples.has_arrived[k]) continue;
    AddRow(stream, RoundTo(experiment.start_time + t, kStampResolution), row);
  }
  return stream;
}

Stream NoisyPoses(const PlaceShown& shown,
                  double delay,
                  const Experiment& experiment,
                  std::uint64_t seed,
                  Log& log) {
  const PoseSensor& sensor = *experiment.pose;
  const SampleTimes samples = PoseSamples(experiment, seed);
  RemarkOnDropOuts(samples, "pose.csv", log);
  RandomStream position_noise(seed, "pose.noise.position");
  RandomStream angle_noise(seed, "pose.noise.angle");
  OutlierSource outliers(sensor.outlier_probability, RandomStream(seed, "pose.outliers"));
  Stream stream;
  stream.columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  stream.values.resize(stream.columns.size());
  for (std::size_t k = 0; k < samples.time.size(); ++k) {
    const double t = samples.time[k];
    const ShownPlace place = shown(k, t);
    outliers.NextSample();
    const Eigen::Vector3d p = place.position + sensor.position_noise * Normal3(position_noise) +
                              sensor.outlier_position * Normal3(outliers);
    const Eigen::Vector3d turn =
        sensor.angle_noise * Normal3(angle_noise) + sensor.outlier_angle * Normal3(outliers);
    const double angle = turn.norm();
    const Eigen::Quaterniond body_from_measured(Eigen::AngleAxisd(
        angle, angle > 0.0 ? Eigen::Vector3d(turn / angle) : Eigen::Vector3d::UnitX()));
    const Eigen::Quaterniond q = Eigen::Quaterniond(place.attitude) * body_from_measured;
    if (!samples.has_arrived[k]) continue;
    std::vector<double> row = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
    for (double& number : row) number = RoundTo(number, sensor.resolution);
    AddRow(stream, RoundTo(experiment.start_time + t + delay, kStampResolution), row);
  }
  return stream;
}

}  // namespace fathom
