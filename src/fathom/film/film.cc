// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/film.h"

#include "fathom/base/random_stream.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

namespace fathom {
namespace {

// A smooth random function of time: mean 0, standard deviation 1.
class SlowMotion {
 public:
  SlowMotion(std::uint64_t seed, const std::string& purpose) {
    RandomStream random(seed, purpose);
    for (Wave& wave : waves_) {
      wave.frequency = 0.3 + 0.9 * random.Uniform();
      wave.phase = 2.0 * std::numbers::pi * random.Uniform();
    }
  }

  double At(double t) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::sin(wave.frequency * t + wave.phase);
    return std::sqrt(2.0 / static_cast<double>(waves_.size())) * sum;
  }

 private:
  struct Wave {
    double frequency = 0.0;  // [rad/s]
    double phase = 0.0;      // [rad]
  };
  std::array<Wave, 3> waves_;
};

Pose PoseInRow(const Stream& stream, std::size_t row) {
  const auto at = [&](const char* column) { return (*stream.Find(column))[row]; };
  return {Eigen::Quaterniond(at("qw"), at("qx"), at("qy"), at("qz")).normalized(),
          {at("x"), at("y"), at("z")}};
}

// The rotation vector of a turn by at most half a turn.
Eigen::Vector3d VectorOf(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

Eigen::Quaterniond RotationBy(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0.0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

}  // namespace

std::vector<StampedPose> HeldPoses(const Stream& shown,
                                   const std::vector<Dof>& driven,
                                   const Film& film,
                                   std::uint64_t seed) {
  std::array<double, 6> size{};
  std::vector<SlowMotion> motions;
  for (const Dof dof : kAllDofs) {
    motions.emplace_back(seed, "film.hold." + std::string(Name(dof)));
    const bool is_driven = std::find(driven.begin(), driven.end(), dof) != driven.end();
    if (!is_driven) size[Index(dof)] = IsAngular(dof) ? film.hold_angle : film.hold_position;
  }
  std::vector<StampedPose> poses;
  for (std::size_t row = 0; row < shown.time.size(); ++row) {
    Eigen::Matrix<double, 6, 1> step;
    for (int i = 0; i < 6; ++i) step[i] = size[i] * motions[i].At(shown.time[row]);
    const Pose held_from_moved = {RotationBy(step.tail<3>()), step.head<3>()};
    StampedPose stamped;
    stamped.time = shown.time[row];
    stamped.pose = PoseInRow(shown, row) * held_from_moved;
    poses.push_back(stamped);
  }
  return poses;
}

std::vector<Detection> FilmCorners(std::span<const StampedPose> world_from_body,
                                   const Film& film,
                                   std::uint64_t seed) {
  RandomStream noise(seed, "film.corners");
  RandomStream outliers(seed, "film.outliers");
  std::vector<Detection> detections;
  for (const StampedPose& stamped : world_from_body) {
    for (Detection detection : ObserveCorners(film.rig.camera,
                                              film.true_map,
                                              stamped.pose * film.rig.body_from_camera,
                                              stamped.time)) {
      const bool is_outlier =
          film.outlier_probability > 0.0 && outliers.Uniform() < film.outlier_probability;
      for (Eigen::Vector2d& corner : detection.corners) {
        for (double& coordinate : corner) {
          coordinate += film.corner_sigma * noise.Normal();
          if (is_outlier) coordinate += film.outlier_size * outliers.Normal();
        }
      }
      detections.push_back(detection);
    }
  }
  return detections;
}

std::vector<Pose> PosesDuringExposure(std::span<const StampedPose> world_from_body,
                                      std::size_t frame,
                                      const Film& film) {
  constexpr int kNumPoses = 8;
  const Pose& middle = world_from_body[frame].pose;
  const std::size_t before = frame > 0 ? frame - 1 : frame;
  const std::size_t after = std::min(frame + 1, world_from_body.size() - 1);
  const double duration = world_from_body[after].time - world_from_body[before].time;
  if (film.exposure == 0.0 || !(duration > 0.0)) return {middle * film.rig.body_from_camera};
  const Pose& a = world_from_body[before].pose;
  const Pose& b = world_from_body[after].pose;
  const Eigen::Vector3d speed = (b.translation - a.translation) / duration;
  const Eigen::Vector3d rate = VectorOf(a.rotation.conjugate() * b.rotation) / duration;
  std::vector<Pose> poses;
  for (int i = 0; i < kNumPoses; ++i) {
    const double t = film.exposure * ((i + 0.5) / kNumPoses - 0.5);
    const Pose moved = {(middle.rotation * RotationBy(t * rate)).normalized(),
                        middle.translation + t * speed};
    poses.push_back(moved * film.rig.body_from_camera);
  }
  return poses;
}

}  // namespace fathom
