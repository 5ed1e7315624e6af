// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/logs/marker_logs.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/base/plural.h"
#include "fathom/camera/camera_rig.h"
#include "fathom/camera/detections_file.h"
#include "fathom/joint_refinement/logs/camera_segments.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/signal/signals.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/signal/split_at_gaps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr size_t kFewestFrames = CameraSegments::kFewestFrames;

bool IsSame(const Pose& a, const Pose& b) {
  return a.translation == b.translation && a.rotation.coeffs() == b.rotation.coeffs();
}

bool IsSame(const CameraModel& a, const CameraModel& b) {
  return a.width == b.width && a.height == b.height && a.fx == b.fx && a.fy == b.fy &&
         a.cx == b.cx && a.cy == b.cy && a.lens == b.lens && a.coefficients == b.coefficients;
}

bool IsSame(const MarkerMap& a, const MarkerMap& b) {
  return std::equal(a.markers.begin(),
                    a.markers.end(),
                    b.markers.begin(),
                    b.markers.end(),
                    [](const Marker& m, const Marker& n) {
                      return m.id == n.id && m.size == n.size && m.family == n.family &&
                             m.is_surveyed == n.is_surveyed &&
                             (!m.is_surveyed || IsSame(m.world_from_tag, n.world_from_tag));
                    });
}

// The calibration of all logs together has to be one.
void RequireSame(const CameraRig& rig, const Log& log, const CameraRig& first_rig) {
  const char* const file = !IsSame(rig.camera, first_rig.camera) ? "camera.yaml"
                           : !IsSame(rig.map, first_rig.map)     ? "tags.yaml"
                           : !IsSame(rig.body_from_camera, first_rig.body_from_camera)
                               ? "mount.yaml"
                               : nullptr;
  if (file == nullptr) return;
  throw InputError(fmt::format(
      "{}: differs from the first log's, expected the same in all logs of one fit. Refine the logs "
      "one by one.",
      FileOf(log, file)));
}

bool AllSurveyed(const MarkerMap& map) {
  return std::all_of(map.markers.begin(), map.markers.end(), [](const Marker& marker) {
    return marker.is_surveyed;
  });
}

// Frames without a marker are not in detections.csv: by the usual step between those that are.
int CountMissingFrames(const MarkerTrack& track, double* step) {
  std::vector<double> steps;
  for (size_t k = 1; k < track.pnp.views.size(); ++k) {
    steps.push_back(track.pnp.views[k].time - track.pnp.views[k - 1].time);
  }
  *step = Median(steps);
  double missing = 0.0;
  for (const double one : steps) missing += std::max(0.0, std::round(one / *step) - 1.0);
  return static_cast<int>(std::min(missing, 1e9));
}

// What became of the frames that have a pose.
void Describe(const CameraSegments& cut, std::vector<std::string>* remarks) {
  if (cut.num_early > 0) {
    remarks->push_back(
        fmt::format("Left out: {} before the first command.", Plural(cut.num_early, "frame")));
  }
  if (cut.num_held_out > 0) {
    remarks->push_back(fmt::format("Held out and not refined: {} with a pose.",
                                   Plural(cut.num_held_out, "frame")));
  }
  if (cut.num_silences > 0) {
    remarks->push_back(
        fmt::format("No frame has a pose for over {:g} s, {}. Each gap starts a new segment.",
                    kLongestGap,
                    Plural(cut.num_silences, "time")));
  }
  if (cut.num_short_segments > 0) {
    remarks->push_back(fmt::format("Left out: {} of fewer than {} frames ({}).",
                                   Plural(cut.num_short_segments, "run"),
                                   kFewestFrames,
                                   Plural(cut.num_in_short_segments, "frame")));
  }
}

std::vector<Detection> DetectionsIn(const Log& log) {
  if (!log.detections || log.detections->time.empty()) {
    throw InputError(fmt::format(
        "{}: holds no detections.csv, expected the corners of markers. fathom_track makes it from "
        "images or a video.",
        log.path.string()));
  }
  return DetectionsOf(*log.detections);
}

// What the cutting of all logs left out.
struct LeftOut {
  bool is_all_held_out = true;
  std::vector<std::string> remarks;  // a sentence each, as in MarkerLogs
};

// When each row of a log's command begins to hold, and nothing of what it is.
HeldCommand StampsOfCommand(const Log& log) {
  if (!log.command || log.command->time.empty()) {
    throw InputError(fmt::format(
        "{}: holds no command.csv, expected the forces or thrusters that drove the vehicle.",
        log.path.string()));
  }
  return {log.command->time, std::vector<double>(log.command->time.size(), 0.0)};
}

// Tracks one log and adds its segments.
void Add(Log log,
         const HeldCommand& command,
         const CameraRig& rig,
         MarkerLogs* result,
         LeftOut* left_out) {
  std::vector<std::string> remarks = rig.remarks;
  const std::vector<Detection> detections = DetectionsIn(log);
  MarkerTrajectoryOptions options;
  options.pose_track.name = FileOf(log, "detections.csv");
  const MarkerTrack track =
      TrackMarkers(detections, rig.camera, rig.map, rig.body_from_camera, options);
  if (log.pose) remarks.push_back("pose.csv is not read: the poses come from detections.csv.");
  const std::vector<std::string> of_track = TextsOf(track.remarks);
  remarks.insert(remarks.end(), of_track.begin(), of_track.end());
  if (track.world_from_body.size() < kFewestFrames) {
    throw InputError(
        fmt::format("{}: {} of {} frames gave a pose, expected at least {}.{}{}",
                    FileOf(log, "detections.csv"),
                    track.world_from_body.size(),
                    track.pnp.num_frames,
                    kFewestFrames,
                    track.message.empty() ? "" : " " + track.message,
                    fmt::format("{}{}", of_track.empty() ? "" : " ", fmt::join(of_track, " "))));
  }
  remarks.push_back(fmt::format("{} of {} frames with markers gave a pose; corner sigma {:.3g} px.",
                                track.world_from_body.size(),
                                track.pnp.num_frames,
                                track.corner_sigma));
  double step = 0.0;
  if (const int missing = CountMissingFrames(track, &step); missing > 0) {
    remarks.push_back(
        fmt::format("About {} in between {} without a pose, estimated from the usual step of "
                    "{:.3g} s.",
                    Plural(missing, "frame"),
                    missing == 1 ? "is" : "are",
                    step));
  }
  CameraSegments cut = CutIntoSegments(detections, track, command.time.front(), log.held_out);
  const bool is_held_out =
      cut.num_held_out > 0 && cut.segments.empty() && cut.num_short_segments == 0;
  left_out->is_all_held_out = left_out->is_all_held_out && is_held_out;
  for (CameraSegment& segment : cut.segments) {
    segment.command = command;
    result->input.segments.push_back(std::move(segment));
    result->log_of_segment.push_back(result->logs.size());
  }
  for (const MovedMarker& moved : track.moved_markers) {
    result->moved_markers.push_back({result->logs.size(), moved});
  }
  const size_t num_before = remarks.size();
  Describe(cut, &remarks);
  for (size_t i = 0; i < remarks.size(); ++i) {
    result->remarks.push_back(fmt::format("{}: {}", log.name, remarks[i]));
    if (i >= num_before) left_out->remarks.push_back(result->remarks.back());
  }
  // Markers without a survey were given a place on the way.
  result->input.map = track.map;
  log.pose = PoseStreamOf(track.world_from_body);
  result->logs.push_back(std::move(log));
}

// The reason first: what else was said of the logs does not matter then.
[[noreturn]] void ThrowNothingIsLeft(const MarkerLogs& result, const LeftOut& left_out) {
  if (result.logs.empty()) throw InputError("no log is given, expected at least one.");
  const Log& log = result.logs.front();
  if (left_out.is_all_held_out) {
    throw InputError(fmt::format("{}: {}", FileOf(log, "log.yaml"), kAllIsHeldOut));
  }
  throw InputError(fmt::format(
      "{}: nothing is left to refine, expected at least {} frames with a pose in a row. {}",
      FileOf(log, "detections.csv"),
      kFewestFrames,
      fmt::join(left_out.remarks, " ")));
}

// `dof`: nothing where several move together, each by forces of its own.
MarkerLogs Prepare(std::vector<Log> logs, std::optional<Dof> dof) {
  MarkerLogs result;
  if (dof) result.dof = result.input.dof = *dof;
  std::optional<CameraRig> first;
  LeftOut left_out;
  const std::string unit = logs.empty() ? "" : logs.front().command_unit;
  for (Log& log : logs) {
    DetectionsIn(log);
    const CameraRig rig = ReadCameraRig(log.path);
    if (first) RequireSame(rig, log, *first);
    if (logs.size() > 1 && !AllSurveyed(rig.map)) {
      throw InputError(fmt::format(
          "{}: has markers without a place, expected a place for each where several logs are "
          "refined together: fathom_track writes tags_estimated.yaml.",
          FileOf(log, "tags.yaml")));
    }
    if (log.command_unit != unit) {
      throw InputError(fmt::format("{}: its command_unit is '{}', expected '{}' as in the first.",
                                   FileOf(log, "log.yaml"),
                                   log.command_unit,
                                   unit));
    }
    if (!first) {
      first = rig;
      result.input.camera = rig.camera;
      result.input.body_from_camera = rig.body_from_camera;
      if (!AllSurveyed(rig.map)) {
        result.remarks.push_back(
            "The positions of unsurveyed markers come from the bundle adjustment and count as "
            "known. The intervals do not include their error.");
      }
    }
    const HeldCommand command = dof ? CommandOf(log, *dof) : StampsOfCommand(log);
    Add(std::move(log), command, rig, &result, &left_out);
  }
  if (result.input.segments.empty()) ThrowNothingIsLeft(result, left_out);
  return result;
}

}  // namespace

MarkerLogs PrepareMarkerLogs(std::vector<Log> logs, Dof dof) {
  return Prepare(std::move(logs), dof);
}

MarkerLogs PrepareCoupledMarkerLogs(std::vector<Log> logs) {
  return Prepare(std::move(logs), std::nullopt);
}

}  // namespace fathom
