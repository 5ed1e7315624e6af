// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "filmed_plane.h"

#include "fathom/film/film.h"
#include "fathom/film/film_file.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/synthesize/experiment/experiment_file.h"
#include "fathom/synthesize/synthesize.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <fmt/format.h>

namespace fathom {
namespace {

const std::string kFolder = FATHOM_DATA_DIR;

Experiment PlanarExperiment(double duration) {
  const std::string text =
      "name: plane\ncommand_rate: 10\nvelocity: {rate: 10, noise: {surge: 0.01, sway: 0.01, yaw: "
      "0.01}}\npose: {rate: 10, logged: false}\n"
      "surge: {control: open_loop, input: {kind: multisine, rms: 10, frequency: [0.6, 2.5], lines: "
      "12, offset: 0.4}}\n"
      "sway: {control: open_loop, input: {kind: multisine, rms: 10, frequency: [0.6, 2.5], lines: "
      "12, offset: -0.3}}\n"
      "yaw: {control: closed_loop, setpoint: {kind: multisine, rms: 0.15, frequency: [0.3, 1.5], "
      "lines: 8}, pid: {kp: 15, ki: 1, kd: 8, limit: 8}}\n";
  return ParseExperiment(
      "plane.yaml",
      text +
          fmt::format("duration: {}\nheld_out: [{}, {}]\n", duration, duration - 10.0, duration));
}

// The frames outside the held-out interval, as one segment.
CameraSegment SegmentBefore(double until,
                            const std::vector<Detection>& detections,
                            const MarkerTrack& track,
                            const Log& log) {
  CameraSegment segment;
  segment.command = {log.command->time, std::vector<double>(log.command->time.size(), 0.0)};
  for (std::size_t k = 0; k < track.world_from_body.size(); ++k) {
    const TrackedView& view = track.pnp.views[k];
    if (view.time >= until) break;
    segment.time.push_back(view.time);
    segment.world_from_body.push_back(track.world_from_body[k].pose);
    auto& seen = segment.detections.emplace_back();
    for (const int i : view.detections) seen.push_back(detections[static_cast<std::size_t>(i)]);
  }
  return segment;
}

}  // namespace

FilmedPlane FilmPlane(const FilmedPlaneOptions& options) {
  const Vehicle vehicle = ReadVehicleFile(kFolder + "/vehicles/planar_rov.yaml");
  const Experiment experiment = PlanarExperiment(options.duration);
  Film film = ReadFilmFile(kFolder + "/films/wall_four.yaml");
  film.corner_sigma = options.corner_sigma;
  film.hold_position = options.hold_position;
  film.hold_angle = options.hold_angle;
  Log log = Synthesize(vehicle, experiment, options.seed);
  log.name = "plane";
  const auto poses = HeldPoses(ShownPoses(vehicle, experiment, {}, options.seed, film.sampling),
                               log.dofs,
                               film,
                               options.seed);
  const std::vector<Detection> detections = FilmCorners(poses, film, options.seed);
  const MarkerTrack track =
      TrackMarkers(detections, film.rig.camera, film.rig.map, film.rig.body_from_camera);
  FilmedPlane filmed;
  filmed.model = *vehicle.coupled;
  filmed.truth = PoseStreamOf(poses);
  MarkerLogs& logs = filmed.logs;
  logs.input.camera = film.rig.camera;
  logs.input.map = track.map;
  logs.input.body_from_camera = film.rig.body_from_camera;
  logs.input.segments = {SegmentBefore(options.duration - 10.0, detections, track, log)};
  logs.log_of_segment = {0};
  log.pose = PoseStreamOf(track.world_from_body);
  logs.logs.push_back(std::move(log));
  return filmed;
}

}  // namespace fathom
