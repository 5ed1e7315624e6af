// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/film_refinement.h"

#include "fathom/base/input_error.h"
#include "fathom/joint_refinement/motion/pose_chart.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace fathom {
namespace {

std::vector<Log> WithoutVelocity(std::vector<Log> logs) {
  for (Log& log : logs) {
    log.velocity.reset();
    log.corrections.clear();
  }
  return logs;
}

// What drives a log, with the DOFs that are not modelled at rest: how they move is for the
// deviations to say, which know the noise of a pose.
std::shared_ptr<const CoupledInputs> CommandAlone(const CoupledData& data) {
  auto inputs = std::make_shared<CoupledInputs>();
  inputs->command = data.inputs.command;
  inputs->log = data.inputs.log;
  return inputs;
}

Vector6 VelocityNear(const CoupledData& data, double time) {
  for (const CoupledSegment& segment : data.segments) {
    const auto at = std::lower_bound(segment.time.begin(), segment.time.end(), time - 1e-9);
    if (at == segment.time.end() || time < segment.time.front() - 1e-9) continue;
    return MeasuredState(segment, static_cast<std::size_t>(at - segment.time.begin())).nu;
  }
  return Vector6::Zero();
}

// The angles of a segment in the mean: roll, pitch, yaw [rad].
Eigen::Vector3d MeanAngles(const std::vector<Pose>& world_from_body) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
  for (const Pose& pose : world_from_body) {
    const Eigen::Vector3d angles = VectorFromPose(pose).tail<3>();
    sum += angles.array().sin().matrix();
    turn += angles.array().cos().matrix();
  }
  return {std::atan2(sum[0], turn[0]), std::atan2(sum[1], turn[1]), std::atan2(sum[2], turn[2])};
}

// A pose's attitude, with the angles that are not modelled as they are in the mean.
Eigen::Quaterniond HeldAttitude(const Pose& pose,
                                const Eigen::Vector3d& mean,
                                const std::vector<Dof>& dofs) {
  PoseVector eta = VectorFromPose(pose);
  for (const Dof dof : {Dof::kRoll, Dof::kPitch, Dof::kYaw}) {
    if (std::ranges::find(dofs, dof) == dofs.end()) eta[Index(dof)] = mean[Index(dof) - 3];
  }
  return PoseFromVector(eta).rotation;
}

void AddWindows(const CameraSegment& segment,
                std::size_t index,
                const CoupledData& data,
                const std::shared_ptr<const CoupledInputs>& inputs,
                double length,
                CoupledFilm* film) {
  CoupledSegment frames;
  frames.time = segment.time;
  const Eigen::Vector3d mean = MeanAngles(segment.world_from_body);
  for (const SampleWindow& range : WindowsOf(frames, length)) {
    const auto cut = [&](const auto& all) {
      return std::vector(all.begin() + static_cast<std::ptrdiff_t>(range.begin),
                         all.begin() + static_cast<std::ptrdiff_t>(range.end));
    };
    FilmWindow& window = film->windows.emplace_back();
    window.inputs = inputs;
    window.time = cut(segment.time);
    window.detections = cut(segment.detections);
    window.world_from_body = cut(segment.world_from_body);
    window.segment = index;
    const Vector6 nu = VelocityNear(data, window.time.front());
    for (const Dof dof : film->structure.dofs) window.start.nu[Index(dof)] = nu[Index(dof)];
    window.start.attitude =
        HeldAttitude(window.world_from_body.front(), mean, film->structure.dofs).coeffs();
    window.start.position = window.world_from_body.front().translation;
  }
}

CoupledFilm FilmOf(const MarkerLogs& logs,
                   const CoupledIdentification& of_poses,
                   const RigidBody& body,
                   double window) {
  CoupledFilm film;
  film.camera = logs.input.camera;
  film.map = logs.input.map;
  film.body_from_camera = logs.input.body_from_camera;
  film.structure = {
      of_poses.fitted.model.dofs, of_poses.fitted.entries, of_poses.fitted.model.coriolis};
  film.body = body;
  std::vector<std::shared_ptr<const CoupledInputs>> inputs;
  for (const CoupledData& data : of_poses.data) inputs.push_back(CommandAlone(data));
  for (std::size_t r = 0; r < logs.input.segments.size(); ++r) {
    const std::size_t log = logs.log_of_segment[r];
    AddWindows(logs.input.segments[r], r, of_poses.data[log], inputs[log], window, &film);
  }
  return film;
}

// The logs by what judges a model: their own velocities where all have them.
std::vector<CoupledData> JudgesOf(const MarkerLogs& logs,
                                  const std::optional<Vehicle>& vehicle,
                                  const FilmRefinement& refinement) {
  if (!refinement.is_judged_by_velocity) return refinement.of_poses.data;
  const Vehicle of_log = vehicle.value_or(Vehicle());
  std::vector<CoupledData> judges;
  for (const Log& log : logs.logs) {
    judges.push_back(CoupledDataOf(
        log, refinement.film.structure.dofs, of_log.thrusters, of_log.fins, of_log.shafts));
  }
  return judges;
}

double SquaredAngle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return std::pow(a.angularDistance(b), 2);
}

}  // namespace

FilmRefinement RefineCoupled(const MarkerLogs& logs, const FilmRefinementOptions& options) {
  FilmRefinement refinement;
  refinement.remarks = logs.remarks;
  refinement.of_poses = IdentifyCoupled(WithoutVelocity(logs.logs), options.identification);
  const CoupledIdentification& of_poses = refinement.of_poses;
  if (!of_poses.is_usable) {
    refinement.message =
        "the coupled fit of the PnP poses, where the search begins: " + of_poses.message;
    return refinement;
  }
  const std::optional<Vehicle> vehicle = FirstVehicleOf(logs.logs);
  // A fin as the unit of force is not in kilograms.
  const bool is_in_known_unit = of_poses.fitted.force_unit == of_poses.data.front().force_unit;
  const RigidBody body = vehicle && is_in_known_unit ? vehicle->body : RigidBody();
  const double window = options.identification.fit.window;
  refinement.film = FilmOf(logs, of_poses, body, window);
  refinement.joint = FitFilm(refinement.film, of_poses.fitted.model, options.fit);
  refinement.is_usable = refinement.joint.IsUsable();
  refinement.message = refinement.joint.message;
  if (!refinement.is_usable) return refinement;

  refinement.is_judged_by_velocity =
      std::ranges::all_of(logs.logs, [](const Log& log) { return log.velocity.has_value(); });
  refinement.judges = JudgesOf(logs, vehicle, refinement);
  refinement.poses_prediction = PredictCoupled(of_poses.fitted.model, refinement.judges, window);
  refinement.joint_prediction = PredictCoupled(refinement.joint.model, refinement.judges, window);
  if (!refinement.joint_prediction) {
    refinement.is_usable = false;
    refinement.message = "free runs of the model diverge";
    return refinement;
  }
  FittedCoupledModel& fitted = refinement.fitted;
  fitted = of_poses.fitted;
  std::erase_if(fitted.caveats, [&](const std::string& caveat) {
    return std::ranges::count(of_poses.caveats_on_fit, caveat) > 0;
  });
  fitted.model = refinement.joint.model;
  fitted.covariance = refinement.joint.covariance;
  fitted.train = refinement.joint_prediction->train;
  fitted.held_out = refinement.joint_prediction->held_out;
  if (!refinement.joint.settled) {
    fitted.caveats.push_back("The likelihood of the processes was still rising at the last round.");
  }
  return refinement;
}

PathErrors PathErrorsOf(const FilmRefinement& refinement, const Stream& truth) {
  const Poses poses = PosesOf(truth);
  PathErrors errors;
  const auto add = [](const Pose& pose,
                      const Eigen::Vector3d& position,
                      const Eigen::Quaterniond& attitude,
                      PathError* error) {
    error->position += (pose.translation - position).squaredNorm();
    error->angle += SquaredAngle(pose.rotation, attitude);
    ++error->num_frames;
  };
  for (std::size_t w = 0; w < refinement.film.windows.size(); ++w) {
    const FilmWindow& window = refinement.film.windows[w];
    for (std::size_t k = 0; k < window.time.size(); ++k) {
      const double t = window.time[k];
      const auto next = std::lower_bound(truth.time.begin(), truth.time.end(), t - 1e-6);
      if (next == truth.time.end()) continue;
      const auto after = static_cast<std::size_t>(next - truth.time.begin());
      if (after == 0 && truth.time[0] > t + 1e-6) continue;
      const std::size_t before = after > 0 ? after - 1 : after;
      const double step = truth.time[after] - truth.time[before];
      const double share = step > 0.0 ? std::clamp((t - truth.time[before]) / step, 0.0, 1.0) : 0.0;
      const Eigen::Vector3d position =
          (1.0 - share) * poses.position[before] + share * poses.position[after];
      const Eigen::Quaterniond attitude =
          poses.world_from_body[before].slerp(share, poses.world_from_body[after]);
      add(window.world_from_body[k], position, attitude, &errors.of_pnp);
      add(refinement.joint.windows[w].world_from_body[k], position, attitude, &errors.refined);
    }
  }
  if (errors.of_pnp.num_frames == 0) {
    throw InputError("the true poses cover no frame of the film, expected the same time.");
  }
  for (PathError* const error : {&errors.of_pnp, &errors.refined}) {
    error->position = std::sqrt(error->position / error->num_frames);
    error->angle = std::sqrt(error->angle / error->num_frames);
  }
  return errors;
}

}  // namespace fathom
