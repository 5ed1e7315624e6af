// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/geometry/pose.h"
#include "fathom/geometry/pose_increment.h"

#include <Eigen/Core>

namespace fathom {

// Where a corner is drawn less where it was seen, over the corner sigma: two numbers, 0 where both
// agree. Blocks: the step (docs/vision.md (4)) away from world_from_camera, then, for a free
// marker, that away from world_from_tag. False for a point behind the camera.
struct CornerResidual {
  const CameraModel* camera;
  const Pose* world_from_camera;
  const Pose* world_from_tag;
  Eigen::Vector3d corner_in_tag;  // [m]
  Eigen::Vector2d pixel;          // [px]
  double corner_sigma;            // [px]

  template <typename T>
  bool operator()(const T* camera_step, T* residual) const {
    const Eigen::Vector3d corner_in_world = *world_from_tag * corner_in_tag;
    const Eigen::Matrix<T, 3, 1> x_world = corner_in_world.cast<T>();
    return Compare(camera_step, x_world, residual);
  }

  template <typename T>
  bool operator()(const T* camera_step, const T* tag_step, T* residual) const {
    const Eigen::Matrix<T, 3, 1> x_tag = corner_in_tag.cast<T>();
    const Eigen::Matrix<T, 3, 1> x_world = TransformNear(*world_from_tag, tag_step, x_tag);
    return Compare(camera_step, x_world, residual);
  }

 private:
  template <typename T>
  bool Compare(const T* camera_step, const Eigen::Matrix<T, 3, 1>& x_world, T* residual) const {
    const Eigen::Matrix<T, 3, 1> x_camera =
        InverseTransformNear(*world_from_camera, camera_step, x_world);
    if (camera->lens != LensModel::kEquidistant && !(x_camera.z() > 0.0)) return false;
    const Eigen::Matrix<T, 2, 1> drawn = Project(*camera, x_camera);
    residual[0] = (drawn[0] - pixel[0]) / corner_sigma;
    residual[1] = (drawn[1] - pixel[1]) / corner_sigma;
    return true;
  }
};

}  // namespace fathom
