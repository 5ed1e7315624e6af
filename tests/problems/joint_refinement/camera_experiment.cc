// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_experiment.h"

#include "fathom/joint_refinement/logs/camera_segments.h"
#include "fathom/marker_trajectory/marker_trajectory.h"

#include <array>
#include <cmath>
#include <random>

#include "true_motion.h"
#include <Eigen/Dense>

namespace fathom {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

// The vehicle looks along world x at a wall; right is y, down is z.
Eigen::Quaterniond Ahead() {
  Eigen::Matrix3d R;
  R.col(0) = Eigen::Vector3d::UnitY();
  R.col(1) = Eigen::Vector3d::UnitZ();
  R.col(2) = Eigen::Vector3d::UnitX();
  return Eigen::Quaterniond(R);
}

Pose PoseOf(const Vector6& eta) {
  using Axis = Eigen::AngleAxisd;
  return {Axis(eta[5], Eigen::Vector3d::UnitZ()) * Axis(eta[4], Eigen::Vector3d::UnitY()) *
              Axis(eta[3], Eigen::Vector3d::UnitX()),
          eta.head<3>()};
}

// The pose of least reprojection error of one frame, by Gauss-Newton with numerical derivatives.
Vector6 OwnPose(const JointInput& input, const std::vector<Detection>& detections, Vector6 eta) {
  const auto residuals = [&](const Vector6& at) {
    const Pose camera_from_world = (PoseOf(at) * input.body_from_camera).Inverse();
    Eigen::VectorXd r(8 * detections.size());
    for (size_t d = 0; d < detections.size(); ++d) {
      const Marker& marker = *input.map.Find(detections[d].tag_id);
      const auto corners = CornersInTag(marker.size);
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector3d x = camera_from_world * (marker.world_from_tag * corners[i]);
        r.segment<2>(8 * static_cast<Eigen::Index>(d) + 2 * i) =
            Project<double>(input.camera, x) - detections[d].corners[i];
      }
    }
    return r;
  };
  for (int iteration = 0; iteration < 6; ++iteration) {
    const Eigen::VectorXd r = residuals(eta);
    Eigen::MatrixXd J(r.size(), 6);
    for (int i = 0; i < 6; ++i) {
      constexpr double kMove = 1e-6;
      Vector6 moved = eta;
      moved[i] += kMove;
      J.col(i) = (residuals(moved) - r) / kMove;
    }
    Vector6 step = -J.colPivHouseholderQr().solve(r);
    const double size = step.norm();
    if (size > 0.3) step *= 0.3 / size;
    eta += step;
    if (size < 1e-8) break;
  }
  return eta;
}

// The camera, its mount and the wall of markers, as they are thought to be.
JointInput RigOf(const CameraExperiment& experiment) {
  JointInput input;
  input.dof = experiment.dof;
  input.camera = {.width = 2040,
                  .height = 2040,
                  .fx = experiment.focal_length,
                  .fy = experiment.focal_length + 5.0,
                  .cx = 1018.0,
                  .cy = 1022.0,
                  .lens = LensModel::kPlumbBob,
                  .coefficients = {-0.05, 0.02, 0.0005, -0.0004, 0.0}};
  input.body_from_camera = {Ahead(), {0.9, 0.05, 0.1}};
  const double wall = input.body_from_camera.translation.x() + experiment.distance;
  const double side = experiment.marker_side;
  if (experiment.num_markers == 1) {
    input.map.markers = {{3, side, "tag36h11", {Ahead(), {wall, 0.1, 0.1}}}};
  } else {
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d place(wall, i % 2 == 0 ? -0.6 : 0.6, i / 2 == 0 ? -0.45 : 0.45);
      input.map.markers.push_back({i, side, "tag36h11", {Ahead(), place}});
    }
  }
  return input;
}

// Draws as a detector would err.
class CornerErrors {
 public:
  CornerErrors(const CameraExperiment& experiment, std::mt19937* generator)
      : experiment_(experiment), generator_(generator) {}

  void AddTo(std::vector<Detection>* seen) {
    for (Detection& detection : *seen) {
      Scatter(experiment_.corner_noise, &detection);
      if (Uniform() < experiment_.outliers) Scatter(10.0, &detection);
    }
  }

  double Uniform() { return uniform_(*generator_); }

 private:
  void Scatter(double size, Detection* detection) {
    for (auto& corner : detection->corners) {
      corner.x() += size * normal_(*generator_);
      corner.y() += size * normal_(*generator_);
    }
  }

  const CameraExperiment& experiment_;
  std::mt19937* const generator_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
};

// The other solution of a square: turned about it by twice the angle to the line of sight.
Pose FlippedPose(const JointInput& input, const std::vector<Detection>& seen, Vector6 eta) {
  eta[4] -= 0.5;
  Pose pose = PoseOf(OwnPose(input, seen, eta));
  pose.rotation = pose.rotation * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY());
  pose.translation.z() += 1.0;
  return pose;
}

}  // namespace

UncoupledModel<double> FlatFish(Dof dof) {
  switch (dof) {
    case Dof::kSurge:
      return {851.05, 8.62, 39.57, -0.81};
    case Dof::kHeave:
      return {1511.53, 1911.21, 31.4, -12.42};
    default:
      return {301.60, 279.39, 26.92, -0.0909};
  }
}

SyntheticCameraRun Synthesize(const CameraExperiment& experiment) {
  std::seed_seq seeds{experiment.seed,
                      static_cast<unsigned>(Index(experiment.dof)),
                      static_cast<unsigned>(experiment.input)};
  std::mt19937 generator(seeds);
  SyntheticCameraRun run;
  run.truth = experiment.vehicle.value_or(FlatFish(experiment.dof));
  const TrueMotion motion = Move(experiment, run.truth, &generator);
  JointInput& input = run.input;
  input = RigOf(experiment);
  MarkerMap true_map = input.map;
  for (Marker& marker : true_map.markers) marker.size *= experiment.size_scale;
  Pose true_mount = input.body_from_camera;
  true_mount.translation += Eigen::Vector3d::Map(experiment.mount_error.data());

  std::array<std::vector<double>, 6> wander;
  for (auto& path : wander) path = Wander(experiment.wander, motion.x.size(), &generator);
  const std::vector<double> pitching =
      experiment.pitch_frequency > 0.0
          ? Swing(motion.a, experiment.pitch_frequency, experiment.pitch_damping)
          : motion.a;
  CornerErrors errors(experiment, &generator);
  CameraSegment segment;
  segment.command = motion.command;
  const int num_frames = static_cast<int>(std::lround(experiment.duration * experiment.rate));
  for (int k = 0; k < num_frames; ++k) {
    const double t = 0.3 + k / experiment.rate + 0.004 * (errors.Uniform() - 0.5);
    const auto i = static_cast<size_t>(t / kTrueStep);
    const double s = t / kTrueStep - static_cast<double>(i);
    const TrueState state = StateAt(motion, i, s);
    Vector6 eta;
    for (int j = 0; j < 6; ++j) {
      const double path = wander[j][i] + s * (wander[j][i + 1] - wander[j][i]);
      eta[j] = (j < 3 ? experiment.wander_position : experiment.wander_angle) * path;
    }
    eta[4] += experiment.pitch_per_acceleration * pitching[i];
    eta[Index(experiment.dof)] = state.displacement;
    const Pose truth = PoseOf(eta);
    std::vector<Detection> seen = ObserveCorners(input.camera, true_map, truth * true_mount, t);
    if (seen.empty()) continue;
    errors.AddTo(&seen);
    Pose guess = PoseOf(OwnPose(input, seen, eta));
    if (errors.Uniform() < experiment.flips) guess = FlippedPose(input, seen, eta);
    segment.time.push_back(t - experiment.clock_offset);
    segment.detections.push_back(std::move(seen));
    segment.world_from_body.push_back(guess);
    run.true_velocity.push_back(state.speed);
    run.true_displacement.push_back(state.displacement);
    run.true_world_from_body.push_back(truth);
  }
  input.segments.push_back(std::move(segment));
  return run;
}

JointInput Tracked(const SyntheticCameraRun& run) {
  const CameraSegment& segment = run.input.segments[0];
  std::vector<Detection> all;
  for (size_t k = 0; k < segment.time.size(); ++k) {
    for (Detection detection : segment.detections[k]) {
      detection.time = segment.time[k];
      all.push_back(detection);
    }
  }
  const MarkerTrack track =
      TrackMarkers(all, run.input.camera, run.input.map, run.input.body_from_camera);
  JointInput input = run.input;
  input.segments = CutIntoSegments(all, track).segments;
  for (CameraSegment& own : input.segments) own.command = segment.command;
  return input;
}

CameraExperiment BeforeADistantMarker(double duration, unsigned seed) {
  CameraExperiment experiment = {.dof = Dof::kSurge,
                                 .input = InputKind::kMultisine,
                                 .duration = duration,
                                 .corner_noise = 0.4,
                                 .wander = WanderKind::kBand,
                                 .wander_position = 0.02,
                                 .wander_angle = 0.015,
                                 .outliers = 0.02};
  experiment.distance = 6.3;
  experiment.marker_side = 0.25;
  experiment.focal_length = 1000.0;
  experiment.vehicle = UncoupledModel<double>{20.0, 20.0, 4.0, 0.13};
  experiment.seed = seed;
  return experiment;
}

Log PoseLog(const SyntheticCameraRun& run) {
  Log log;
  const CameraSegment& camera = run.input.segments[0];
  Stream pose, command;
  pose.time = camera.time;
  pose.columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  pose.values.resize(7);
  for (const Pose& p : camera.world_from_body) {
    const auto& q = p.rotation;
    const std::array<double, 7> row = {
        p.translation.x(), p.translation.y(), p.translation.z(), q.x(), q.y(), q.z(), q.w()};
    for (int i = 0; i < 7; ++i) pose.values[i].push_back(row[i]);
  }
  command.time = camera.command.time;
  command.columns = {std::string(ForceColumn(run.input.dof))};
  command.values = {camera.command.value};
  log.pose = pose;
  log.command = command;
  log.dofs = {run.input.dof};
  return log;
}

}  // namespace fathom
