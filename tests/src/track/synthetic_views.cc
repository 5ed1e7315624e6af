// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "synthetic_views.h"

#include <cmath>

namespace fathom {

CameraModel SyntheticCamera() {
  return {.width = 1280,
          .height = 960,
          .fx = 640.0,
          .fy = 645.0,
          .cx = 633.0,
          .cy = 487.0,
          .lens = LensModel::kPlumbBob,
          .coefficients = {-0.11, 0.02, 0.0004, -0.0003, -0.001}};
}

Pose OnTheWall(double east, double down) {
  Eigen::Matrix3d world_from_tag;
  world_from_tag << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  return {Eigen::Quaterniond(world_from_tag), {3.0, east, down}};
}

MarkerMap SingleMarker() {
  return {{{.id = 0, .size = 0.4, .family = "tag36h11", .world_from_tag = OnTheWall(0.0, 0.0)}}};
}

MarkerMap FourMarkers() {
  MarkerMap map;
  int id = 0;
  for (const double east : {-0.6, 0.6}) {
    for (const double down : {-0.4, 0.4}) {
      map.markers.push_back(
          {.id = id++, .size = 0.2, .family = "tag36h11", .world_from_tag = OnTheWall(east, down)});
    }
  }
  return map;
}

Pose CameraPoseAt(double t, double tilt) {
  Pose pose = OnTheWall(0.2 * std::sin(0.5 * t), 0.15 * std::sin(0.3 * t));
  pose.translation.x() = 0.4 * std::sin(0.4 * t);
  pose.translation.y() -= 2.5 * std::sin(tilt);
  const Eigen::Vector3d phi(0.05 * std::sin(0.7 * t), tilt + 0.04 * std::sin(0.6 * t), 0.0);
  pose.rotation =
      pose.rotation *
      Eigen::AngleAxisd(phi.norm() + 1e-12, (phi + Eigen::Vector3d(1e-12, 0, 0)).normalized());
  return pose;
}

void AddNoise(double sigma, std::mt19937* random, std::vector<Detection>* detections) {
  std::normal_distribution<double> normal;
  for (Detection& detection : *detections) {
    for (Eigen::Vector2d& corner : detection.corners) {
      corner.x() += sigma * normal(*random);
      corner.y() += sigma * normal(*random);
    }
  }
}

void PutElsewhere(double farthest, std::mt19937* random, Detection* detection) {
  std::uniform_real_distribution<double> u(100.0, 1180.0), v(100.0, 860.0), half(10.0, 50.0);
  std::uniform_real_distribution<double> turn(-0.5, 0.5);
  const Eigen::Vector2d was = 0.25 * (detection->corners[0] + detection->corners[1] +
                                      detection->corners[2] + detection->corners[3]);
  Eigen::Vector2d centre;
  do {
    centre = {u(*random), v(*random)};
  } while ((centre - was).norm() < 5.0 || (centre - was).norm() > farthest);
  const double angle = turn(*random), size = half(*random);
  const Eigen::Vector2d right(size * std::cos(angle), size * std::sin(angle));
  const Eigen::Vector2d down(-right.y(), right.x());
  detection->corners = {
      centre - right + down, centre + right + down, centre + right - down, centre - right - down};
}

SyntheticRecord MakeRecord(
    const MarkerMap& map, int num_frames, double tilt, double sigma, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.02, 0.02);
  SyntheticRecord record;
  for (int i = 0; i < num_frames; ++i) {
    const double t = 100.0 + 0.1 * i + jitter(random);
    record.time.push_back(t);
    record.world_from_camera.push_back(CameraPoseAt(t, tilt));
    for (const Detection& detection :
         ObserveCorners(SyntheticCamera(), map, record.world_from_camera.back(), t)) {
      record.detections.push_back(detection);
    }
  }
  AddNoise(sigma, &random, &record.detections);
  return record;
}

CameraModel WallCamera() {
  return {.width = 640,
          .height = 480,
          .fx = 600.0,
          .fy = 600.0,
          .cx = 319.5,
          .cy = 239.5,
          .lens = LensModel::kPlumbBob,
          .coefficients = {0.0, 0.0, 0.0, 0.0, 0.0}};
}

MarkerMap WallOfMarkers(int num, int columns, double pitch, double size) {
  const int rows = (num + columns - 1) / columns;
  MarkerMap map;
  for (int i = 0; i < num; ++i) {
    const double east = (i % columns - 0.5 * (columns - 1)) * pitch;
    const double down = (i / columns - 0.5 * (rows - 1)) * pitch;
    map.markers.push_back(
        {.id = i, .size = size, .family = "tag36h11", .world_from_tag = OnTheWall(east, down)});
  }
  return map;
}

Pose WallPoseAt(double t, double distance, double east) {
  Pose pose = OnTheWall(east + 0.03 * std::sin(0.4 * t), 0.03 * std::cos(0.3 * t));
  pose.translation.x() = 3.0 - distance + 0.1 * std::sin(0.6 * t);
  const Eigen::Vector3d phi(
      0.08 * std::sin(0.5 * t + 1.0), 0.1 * std::sin(0.7 * t), 0.05 * std::sin(0.8 * t));
  pose.rotation = pose.rotation * Eigen::AngleAxisd(phi.norm(), phi.normalized());
  return pose;
}

void AddWallFrame(const MarkerMap& map,
                  double t,
                  const Pose& world_from_camera,
                  double sigma,
                  std::mt19937* random,
                  SyntheticRecord* record) {
  auto seen = ObserveCorners(WallCamera(), map, world_from_camera, t);
  AddNoise(sigma, random, &seen);
  record->time.push_back(t);
  record->world_from_camera.push_back(world_from_camera);
  record->detections.insert(record->detections.end(), seen.begin(), seen.end());
}

SyntheticRecord MakeWallRecord(
    const MarkerMap& map, int num_frames, double distance, double fast_sigma, unsigned seed) {
  std::mt19937 random(seed);
  SyntheticRecord record;
  for (int i = 0; i < num_frames; ++i) {
    const double t = 0.1 * i;
    const double sigma = i % 5 == 2 ? fast_sigma : 0.2;
    AddWallFrame(map, t, WallPoseAt(t, distance), sigma, &random, &record);
  }
  return record;
}

MarkerMap TwelveMarkers() { return WallOfMarkers(12, 4, 0.2, 0.1); }

MarkerMap WrongSurvey(int num_wrong) {
  MarkerMap map = TwelveMarkers();
  for (int i = 12 - num_wrong; i < 12; ++i) {
    map.markers[i].world_from_tag.translation += Eigen::Vector3d(0.0, 0.1, 0.05);
  }
  return map;
}

}  // namespace fathom
