// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/input.h"
#include "fathom/log/log.h"
#include "fathom/marker_trajectory/moved_marker.h"

#include <string>
#include <vector>

namespace fathom {

// Logs of one vehicle before one set of markers, ready for FitJoint().
struct MarkerLogs {
  Dof dof = Dof::kSurge;

  // As read, but with the PnP poses of the detections as their pose stream.
  std::vector<Log> logs;

  // What is trained on: a segment for each unbroken stretch outside the held-out intervals.
  JointInput input;
  std::vector<size_t> log_of_segment;  // index into `logs`

  // Markers that moved during a log, each with the index of that log.
  struct Moved {
    size_t log = 0;
    MovedMarker marker;
  };
  std::vector<Moved> moved_markers;

  // What was left out or decided on the way, counted, a sentence each.
  std::vector<std::string> remarks;
};

// Tracks the markers of each log (TrackMarkers) and cuts the frames with a pose into segments: at a
// silence of over 30 s, as SignalsOf() does, and at the held-out intervals. Frames before the first
// command and segments of fewer than 10 frames are left out and counted.
//
// Throws InputError if a log lacks detections, a command or a calibration, if the logs differ in
// camera, mount, markers or units, or if nothing is left to train on.
MarkerLogs PrepareMarkerLogs(std::vector<Log> logs, Dof dof);

// The same for a model of several DOFs: the segments have the stamps of the command, but no force.
MarkerLogs PrepareCoupledMarkerLogs(std::vector<Log> logs);

}  // namespace fathom
