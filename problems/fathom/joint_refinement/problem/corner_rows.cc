// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/corner_rows.h"

#include "fathom/base/flattened.h"

#include <ceres/jet.h>

namespace fathom {
namespace {

constexpr double kClosest = 1e-3;  // depth of a corner that can be projected [m]

template <typename T>
Eigen::Matrix<T, 3, 3> Skew(const Eigen::Matrix<T, 3, 1>& w) {
  Eigen::Matrix<T, 3, 3> S;
  S << T(0.0), -w[2], w[1], w[2], T(0.0), -w[0], -w[1], w[0], T(0.0);
  return S;
}

// x_camera of the point of a tag, for all orders of derivatives that Newton's method needs: the
// mount's rotation to second order about none.
template <typename T>
FATHOM_FLATTENED bool ProjectCorners(const CameraSetup& setup,
                                     const Marker& marker,
                                     const T* eta,
                                     const T& size_scale,
                                     const T* mount,
                                     Eigen::Matrix<T, 8, 1>* pixels) {
  using Vector = Eigen::Matrix<T, 3, 1>;
  const Eigen::Matrix<T, 3, 3> body_from_world =
      RotationFromAngles(eta[3], eta[4], eta[5]).transpose();
  const Vector body_in_world(eta[0], eta[1], eta[2]);
  const Eigen::Matrix3d camera_from_body =
      setup.body_from_camera.rotation.conjugate().toRotationMatrix();
  const Vector camera_in_body =
      setup.body_from_camera.translation.cast<T>() + Vector(mount[0], mount[1], mount[2]);
  const Eigen::Matrix<T, 3, 3> turn = Skew(Vector(mount[3], mount[4], mount[5]));
  const auto corners = CornersInTag(marker.size);
  const Eigen::Matrix3d world_from_tag = marker.world_from_tag.rotation.toRotationMatrix();
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d arm = world_from_tag * corners[i];
    const Vector x_world = marker.world_from_tag.translation.cast<T>() + size_scale * arm.cast<T>();
    const Vector x_body = body_from_world * Vector(x_world - body_in_world);
    const Vector x_unturned = camera_from_body.cast<T>() * Vector(x_body - camera_in_body);
    const Vector once = turn * x_unturned;
    const Vector x_camera = x_unturned - once + T(0.5) * (turn * once);
    if (!(x_camera[2] > kClosest)) return false;
    pixels->template segment<2>(2 * i) = Project(setup.camera, x_camera);
  }
  return true;
}

template <int kSize>
bool Evaluate(const CameraSetup& setup,
              const SetupUnknowns& unknowns,
              const Marker& marker,
              const Detection& detection,
              const PoseVector& eta,
              double corner_sigma,
              CornerRows* rows) {
  using Jet = ceres::Jet<double, kSize>;
  std::array<Jet, 6> eta_jet, mount;
  for (int i = 0; i < 6; ++i) eta_jet[i] = Jet(eta[i], i);
  Jet size_scale(unknowns.size_scale);
  for (int i = 0; i < 6; ++i) mount[i] = Jet(unknowns.mount[i]);
  if constexpr (kSize > 6) {
    size_scale.v[6] = 1.0;
    for (int i = 0; i < 6; ++i) mount[i].v[7 + i] = 1.0;
  }
  Eigen::Matrix<Jet, 8, 1> pixels;
  if (!ProjectCorners(setup, marker, eta_jet.data(), size_scale, mount.data(), &pixels)) {
    return false;
  }
  const double weight = 1.0 / corner_sigma;
  for (int row = 0; row < 8; ++row) {
    rows->residual[row] = weight * (pixels[row].a - detection.corners[row / 2][row % 2]);
    rows->by_pose.row(row) = weight * pixels[row].v.template head<6>().transpose();
    if constexpr (kSize > 6) {
      rows->by_setup.row(row) = weight * pixels[row].v.template tail<7>().transpose();
    }
  }
  return true;
}

}  // namespace

bool EvaluateCorners(const CameraSetup& setup,
                     const SetupUnknowns& unknowns,
                     const Marker& marker,
                     const Detection& detection,
                     const PoseVector& eta,
                     double corner_sigma,
                     bool with_setup,
                     CornerRows* rows) {
  return with_setup ? Evaluate<13>(setup, unknowns, marker, detection, eta, corner_sigma, rows)
                    : Evaluate<6>(setup, unknowns, marker, detection, eta, corner_sigma, rows);
}

bool EvaluateResidual(const CameraSetup& setup,
                      const SetupUnknowns& unknowns,
                      const Marker& marker,
                      const Detection& detection,
                      const PoseVector& eta,
                      double corner_sigma,
                      Eigen::Matrix<double, 8, 1>* residual) {
  Eigen::Matrix<double, 8, 1> pixels;
  if (!ProjectCorners(
          setup, marker, eta.data(), unknowns.size_scale, unknowns.mount.data(), &pixels)) {
    return false;
  }
  const double weight = 1.0 / corner_sigma;
  for (int row = 0; row < 8; ++row) {
    (*residual)[row] = weight * (pixels[row] - detection.corners[row / 2][row % 2]);
  }
  return true;
}

}  // namespace fathom
