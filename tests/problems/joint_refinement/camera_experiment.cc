// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera_experiment.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Dense>

namespace fathom {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kStep = 0.0025;  // of the integration [s]

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

// Force as a function of time, displacement and speed; called every 1 / rate.
using Controller = std::function<double(double t, double x)>;

struct Motion {
  std::vector<double> x, v, a;  // every kStep
  HeldCommand command;
};

Motion Integrate(const UncoupledModel<double>& m,
                 const CameraExperiment& experiment,
                 double v0,
                 const Controller& controller) {
  Motion motion;
  // A force that the command does not show; a generator of its own leaves the other draws alone.
  std::mt19937 pushes(experiment.seed + 7919);
  std::normal_distribution<double> normal;
  const double decay = std::exp(-kStep / 2.0);
  double push = 0.0;
  double x = 0.0, v = v0;
  const int per_command = static_cast<int>(std::lround(1.0 / (experiment.rate * kStep)));
  const int num_steps = static_cast<int>(std::lround((experiment.duration + 1.0) / kStep));
  double tau = 0.0;
  for (int i = 0; i <= num_steps; ++i) {
    const double t = i * kStep;
    if (i % per_command == 0) {
      tau = controller(t, x);
      motion.command.time.push_back(t);
      motion.command.value.push_back(tau);
    }
    if (experiment.disturbance > 0.0) {
      push =
          decay * push + std::sqrt(1.0 - decay * decay) * experiment.disturbance * normal(pushes);
    }
    const auto a = [&](double speed) {
      return (tau + push - m.quadratic_damping * speed * std::abs(speed) -
              m.linear_damping * speed - m.buoyancy) /
             m.inertia;
    };
    motion.x.push_back(x);
    motion.v.push_back(v);
    motion.a.push_back(a(v));
    const double h = kStep;
    const double k1 = a(v), k2 = a(v + 0.5 * h * k1), k3 = a(v + 0.5 * h * k2), k4 = a(v + h * k3);
    x += h * (v + h / 6.0 * (k1 + k2 + k3));
    v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return motion;
}

// Eight lines between 0.1 and 0.9 rad/s.
struct Multisine {
  std::array<double, 8> frequency, phase;
  double amplitude;  // of each

  Multisine(double each, std::mt19937* generator) : amplitude(each) {
    std::uniform_real_distribution<double> any(0.0, 2.0 * std::numbers::pi);
    for (int i = 0; i < 8; ++i) {
      frequency[i] = 0.1 + 0.8 * i / 7.0;
      phase[i] = any(*generator);
    }
  }
  // Derivative `order` at `t`.
  double At(double t, int order) const {
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
      sum += amplitude * std::pow(frequency[i], order) *
             std::sin(frequency[i] * t + phase[i] + order * 0.5 * std::numbers::pi);
    }
    return sum;
  }
};

Motion Move(const CameraExperiment& experiment,
            const UncoupledModel<double>& m,
            std::mt19937* generator) {
  const double dt = 1.0 / experiment.rate;
  if (experiment.dof == Dof::kSurge) {  // open loop, trimmed by the buoyancy
    if (experiment.input == InputKind::kSine) {
      return Integrate(m, experiment, 0.0, [&](double t, double) {
        return m.buoyancy + 52.9 * std::cos(0.3 * t);
      });
    }
    if (experiment.input == InputKind::kSteps) {
      return Integrate(m, experiment, 0.0, [&](double t, double) {
        const int level = static_cast<int>(t / 7.0) % 4;
        return m.buoyancy + (level == 0 || level == 3 ? 20.0 : -20.0);
      });
    }
    const Multisine x(0.15, generator);
    return Integrate(m, experiment, x.At(0.0, 1), [&](double t, double) {
      const double v = x.At(t, 1);
      return m.inertia * x.At(t, 2) + m.quadratic_damping * v * std::abs(v) + m.linear_damping * v +
             m.buoyancy;
    });
  }
  // Closed loop: PID, as in data/experiments/table1.yaml.
  const bool heave = experiment.dof == Dof::kHeave;
  const double kp = heave ? 3000.0 : 600.0, ki = heave ? 300.0 : 60.0, kd = heave ? 2500.0 : 500.0;
  const double limit = heave ? 800.0 : 150.0;
  const Multisine lines(heave ? 0.15 : 0.05, generator);
  const auto setpoint = [&](double t) {
    if (experiment.input == InputKind::kSine) return (heave ? 1.0 : 0.3) * std::sin(0.3 * t);
    if (experiment.input == InputKind::kMultisine) return lines.At(t, 0) - lines.At(0.0, 0);
    const double level = heave ? 0.4 : 0.25;
    return static_cast<int>(t / 15.0) % 2 == 0 ? level : -level;
  };
  double integral = 0.0, last = 0.0;
  bool is_first = true;
  return Integrate(m, experiment, 0.0, [&](double t, double x) {
    const double error = setpoint(t) - x;
    const double slope = is_first ? 0.0 : (error - last) / dt;
    is_first = false;
    integral += error * dt;
    last = error;
    return std::clamp(kp * error + ki * integral + kd * slope, -limit, limit);
  });
}

// What a held coordinate does, every kStep, with standard deviation 1.
std::vector<double> Wander(WanderKind kind, size_t n, std::mt19937* generator) {
  std::normal_distribution<double> normal;
  std::vector<double> path(n, 0.0);
  if (kind == WanderKind::kNone) return path;
  if (kind == WanderKind::kSinusoids) {
    std::uniform_real_distribution<double> any(0.0, 2.0 * std::numbers::pi);
    for (int line = 0; line < 12; ++line) {
      const double frequency = 0.03 * std::pow(1.3, line), phase = any(*generator);
      for (size_t i = 0; i < n; ++i) {
        path[i] +=
            std::sqrt(2.0 / 12.0) * std::sin(frequency * static_cast<double>(i) * kStep + phase);
      }
    }
    return path;
  }
  const double slow = 3.0, quick = kind == WanderKind::kRough ? 0.0 : 0.5;  // time constants [s]
  const double decay = std::exp(-kStep / slow);
  double u = normal(*generator), y = u;
  // Of u through the lag: variance slow / (slow + quick).
  const double scale = std::sqrt((slow + quick) / slow);
  for (size_t i = 0; i < n; ++i) {
    path[i] = scale * y;
    u = decay * u + std::sqrt(1.0 - decay * decay) * normal(*generator);
    y = quick > 0.0 ? y + (u - y) * (1.0 - std::exp(-kStep / quick)) : u;
  }
  return path;
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
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  SyntheticCameraRun run;
  run.truth = FlatFish(experiment.dof);
  const Motion motion = Move(experiment, run.truth, &generator);

  JointInput& input = run.input;
  input.dof = experiment.dof;
  input.camera = {.width = 2040,
                  .height = 2040,
                  .fx = 1400.0,
                  .fy = 1405.0,
                  .cx = 1018.0,
                  .cy = 1022.0,
                  .lens = LensModel::kPlumbBob,
                  .coefficients = {-0.05, 0.02, 0.0005, -0.0004, 0.0}};
  input.body_from_camera = {Ahead(), {0.9, 0.05, 0.1}};
  const double wall = 4.2;  // [m] ahead of the body, 3.3 m of the camera
  constexpr double kSide = 0.4;
  if (experiment.num_markers == 1) {
    input.map.markers = {{3, kSide, "tag36h11", {Ahead(), {wall, 0.1, 0.1}}}};
  } else {
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d place(wall, i % 2 == 0 ? -0.6 : 0.6, i / 2 == 0 ? -0.45 : 0.45);
      input.map.markers.push_back({i, kSide, "tag36h11", {Ahead(), place}});
    }
  }
  MarkerMap true_map = input.map;
  for (Marker& marker : true_map.markers) marker.size *= experiment.size_scale;
  Pose true_mount = input.body_from_camera;
  true_mount.translation += Eigen::Vector3d::Map(experiment.mount_error.data());

  std::array<std::vector<double>, 6> wander;
  for (auto& path : wander) path = Wander(experiment.wander, motion.x.size(), &generator);
  CameraRun camera_run;
  camera_run.command = motion.command;
  const int excited = Index(experiment.dof);
  const int num_frames = static_cast<int>(std::lround(experiment.duration * experiment.rate));
  for (int k = 0; k < num_frames; ++k) {
    const double t = 0.3 + k / experiment.rate + 0.004 * (uniform(generator) - 0.5);
    // Cubic Hermite between the steps of the integration.
    const auto i = static_cast<size_t>(t / kStep);
    const double h = kStep, s = t / kStep - static_cast<double>(i);
    const auto& [x, v, a, command] = motion;
    const double s2 = s * s, s3 = s2 * s;
    const double displacement = (2 * s3 - 3 * s2 + 1) * x[i] + (s3 - 2 * s2 + s) * h * v[i] +
                                (3 * s2 - 2 * s3) * x[i + 1] + (s3 - s2) * h * v[i + 1];
    const double speed = v[i] + s * (v[i + 1] - v[i]);
    Vector6 eta;
    for (int j = 0; j < 6; ++j) {
      const double path = wander[j][i] + s * (wander[j][i + 1] - wander[j][i]);
      eta[j] = (j < 3 ? experiment.wander_position : experiment.wander_angle) * path;
    }
    eta[4] += experiment.pitch_per_acceleration * a[i];
    eta[excited] = displacement;
    const Pose truth = PoseOf(eta);
    std::vector<Detection> seen = ObserveCorners(input.camera, true_map, truth * true_mount, t);
    if (seen.empty()) continue;
    for (Detection& detection : seen) {
      for (auto& corner : detection.corners) {
        corner.x() += experiment.corner_noise * normal(generator);
        corner.y() += experiment.corner_noise * normal(generator);
      }
      if (uniform(generator) < experiment.outliers) {
        for (auto& corner : detection.corners) {
          corner.x() += 10.0 * normal(generator);
          corner.y() += 10.0 * normal(generator);
        }
      }
    }
    const Vector6 own = OwnPose(input, seen, eta);
    Pose guess = PoseOf(own);
    if (uniform(generator) < experiment.flips) {
      // The other solution of a square: turned about it by twice the angle to the line of sight.
      Vector6 flipped = eta;
      flipped[4] -= 0.5;
      guess = PoseOf(OwnPose(input, seen, flipped));
      guess.rotation = guess.rotation * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY());
      guess.translation.z() += 1.0;
    }
    camera_run.time.push_back(t - experiment.clock_offset);
    camera_run.detections.push_back(std::move(seen));
    camera_run.world_from_body.push_back(guess);
    run.true_velocity.push_back(speed);
    run.true_displacement.push_back(displacement);
    run.true_world_from_body.push_back(truth);
  }
  input.runs.push_back(std::move(camera_run));
  return run;
}

Log PoseLog(const SyntheticCameraRun& run) {
  Log log;
  const CameraRun& camera = run.input.runs[0];
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
