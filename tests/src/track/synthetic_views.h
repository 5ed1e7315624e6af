// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/marker_map.h"

#include <random>
#include <vector>

namespace fathom {

// A camera with a bent lens, 90 degrees wide.
CameraModel SyntheticCamera();

// A wall ahead (x north): its tags' z axes point north, their x axes east, their y axes down.
Pose OnTheWall(double east, double down);

// One marker of 0.4 m in the middle; or four of 0.2 m around it.
MarkerMap SingleMarker();
MarkerMap FourMarkers();

// The camera looks north from about the origin, `tilt` [rad] off to the east, and moves to and fro.
Pose CameraPoseAt(double t, double tilt);

// Corners with independent normal noise.
void AddNoise(double sigma, std::mt19937* random, std::vector<Detection>* detections);

// A false decode: the right id on a square of somewhere else, up to `farthest` [px] from its
// marker.
void PutElsewhere(double farthest, std::mt19937* random, Detection* detection);

// A mount, and the noise of a good corner [px].
inline const Pose kBodyFromCamera = {Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5), {0.3, -0.1, 0.2}};
inline constexpr double kCornerSigma = 0.3;

struct SyntheticRecord {
  std::vector<double> time;             // of all frames
  std::vector<Pose> world_from_camera;  // the truth
  std::vector<Detection> detections;
};

// Frames at 10 Hz with uneven stamps.
SyntheticRecord MakeRecord(
    const MarkerMap& map, int num_frames, double tilt, double sigma, unsigned seed);

// A wall with many markers before a camera without distortion, 640 x 480.
CameraModel WallCamera();

// `num` markers in rows of `columns`, `pitch` [m] from centre to centre.
MarkerMap WallOfMarkers(int num, int columns, double pitch, double size);

// The camera sways before a wall at `distance` [m], `east` [m] of its middle.
Pose WallPoseAt(double t, double distance, double east = 0.0);

// Adds what the camera sees of a wall, with noise of `sigma` [px].
void AddWallFrame(const MarkerMap& map,
                  double t,
                  const Pose& world_from_camera,
                  double sigma,
                  std::mt19937* random,
                  SyntheticRecord* record);

// Frames at 10 Hz, the noise 0.2 px; every fifth frame, as of a fast turn, has `fast_sigma` [px].
SyntheticRecord MakeWallRecord(
    const MarkerMap& map, int num_frames, double distance, double fast_sigma, unsigned seed);

// Twelve markers, and a survey that has the last `num_wrong` of them 11 cm off.
MarkerMap TwelveMarkers();
MarkerMap WrongSurvey(int num_wrong);

}  // namespace fathom
