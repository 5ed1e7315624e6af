// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/tag_renderer.h"

#include "fathom/base/input_error.h"
#include "fathom/camera/tag_family.h"
#include "fathom/film/clipped_area.h"
#include "fathom/film/pixel_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glog/logging.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace fathom {
namespace {

// A printed marker: its pattern with a white rim of one cell around it.
struct Panel {
  Marker marker;
  TagPattern pattern;
  double cell = 0.0;  // side [m]
  double half = 0.0;  // of the panel [m]

  Panel(const Marker& marker_, const TagPattern& pattern_)
      : marker(marker_),
        pattern(pattern_),
        cell(marker_.size / pattern_.border_width),
        half(cell * (0.5 * pattern_.width + 1.0)) {}

  int num_cells() const { return pattern.width + 2; }

  // A point of the tag plane in cells from the panel's top left.
  Eigen::Vector2d InCells(const Eigen::Vector2d& p) const { return (p.array() + half) / cell; }

  // From 0, black, to 1.
  double WhiteOf(int cell_column, int cell_row) const {
    const int row = cell_row - 1;
    const int column = cell_column - 1;
    const bool is_rim = row < 0 || column < 0 || row >= pattern.width || column >= pattern.width;
    return is_rim ? 1.0 : pattern.At(column, row) / 255.0;
  }
};

// Where the ray from a camera meets the plane of a marker; NaN if it does not.
struct Plane {
  Eigen::Matrix3d tag_from_camera;
  Eigen::Vector3d camera_in_tag;

  explicit Plane(const Pose& tag_from_camera_pose)
      : tag_from_camera(tag_from_camera_pose.rotation.toRotationMatrix()),
        camera_in_tag(tag_from_camera_pose.translation) {}

  bool IsSeenFromAhead() const { return camera_in_tag.z() < 0.0; }

  Eigen::Vector2d Meet(const Eigen::Vector3d& ray_in_camera) const {
    const Eigen::Vector3d ray = tag_from_camera * ray_in_camera;
    const double along = -camera_in_tag.z() / ray.z();
    if (!(ray.z() > 0.0))
      return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    return camera_in_tag.head<2>() + along * ray.head<2>();
  }

  // [m]
  double DistanceOf(const Eigen::Vector2d& p) const {
    return (Eigen::Vector3d(p.x(), p.y(), 0.0) - camera_in_tag).norm();
  }
};

// Pixels from .. to, without the last.
struct PixelBox {
  int u_from = 0, u_to = 0, v_from = 0, v_to = 0;
};

}  // namespace

struct TagRenderer::Implementation {
  CameraModel camera;
  WaterView view;
  double largest_angle = 0.0;  // of the lens, from its axis [rad]
  std::vector<Panel> panels;
  std::vector<Eigen::Vector3f> rays;  // of the corners of the pixels, (width + 1) x (height + 1)

  const Eigen::Vector3f& CornerRay(int u, int v) const {
    return rays[static_cast<std::size_t>(v) * (camera.width + 1) + u];
  }

  bool IsSeen(const Eigen::Vector3d& x_camera) const {
    const double angle = std::atan2(x_camera.head<2>().norm(), x_camera.z());
    return angle < largest_angle && camera.Contains(Project(camera, x_camera));
  }

  double Seen(double brightness, double distance) const {
    if (view.attenuation == 0.0) return brightness;
    const double passed = std::exp(-view.attenuation * distance);
    return brightness * passed + view.veiling_light * (1.0 - passed);
  }

  // The wall behind the markers.
  void DrawWall(const Pose& world_from_camera, std::vector<float>* light) const;

  // The pixels on which the panel may be; all where it leaves the view.
  PixelBox BoxOf(const Panel& panel, std::span<const Pose> world_from_camera) const;

  void DrawPanel(const Panel& panel,
                 std::span<const Pose> world_from_camera,
                 std::vector<float>* light) const;

  // The light of a panel on one pixel, over what is behind it.
  double LightOf(const Panel& panel, const Plane& plane, int u, int v, double behind) const;

  void Vignette(std::vector<float>* light) const;
};

void TagRenderer::Implementation::DrawWall(const Pose& world_from_camera,
                                           std::vector<float>* light) const {
  light->assign(static_cast<std::size_t>(camera.width) * camera.height,
                static_cast<float>(view.veiling_light));
  if (panels.empty()) return;
  const Plane plane(panels.front().marker.world_from_tag.Inverse() * world_from_camera);
  if (!plane.IsSeenFromAhead()) return;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector2d p = plane.Meet(CornerRay(u, v).cast<double>());
      if (!p.allFinite()) continue;
      (*light)[static_cast<std::size_t>(v) * camera.width + u] =
          static_cast<float>(Seen(view.wall, plane.DistanceOf(p)));
    }
  }
}

PixelBox TagRenderer::Implementation::BoxOf(const Panel& panel,
                                            std::span<const Pose> world_from_camera) const {
  constexpr int kPointsPerSide = 16;
  constexpr double kMargin = 3.0;  // [px], for what a side bulges between its points
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;
  for (const Pose& pose : world_from_camera) {
    const Pose camera_from_tag = pose.Inverse() * panel.marker.world_from_tag;
    for (int i = 0; i < 4 * kPointsPerSide; ++i) {
      const double s = 2.0 * (i % kPointsPerSide) / kPointsPerSide - 1.0;
      const std::array<Eigen::Vector2d, 4> sides = {{{s, -1.0}, {1.0, s}, {-s, 1.0}, {-1.0, -s}}};
      const Eigen::Vector2d p = panel.half * sides[i / kPointsPerSide];
      const Eigen::Vector3d x_camera = camera_from_tag * Eigen::Vector3d(p.x(), p.y(), 0.0);
      if (!IsSeen(x_camera)) return {0, camera.width, 0, camera.height};
      const Eigen::Array2d pixel = Project(camera, x_camera).array();
      low = low.min(pixel);
      high = high.max(pixel);
    }
  }
  return {std::max(0, static_cast<int>(low.x() - kMargin)),
          std::min(camera.width, static_cast<int>(high.x() + kMargin) + 1),
          std::max(0, static_cast<int>(low.y() - kMargin)),
          std::min(camera.height, static_cast<int>(high.y() + kMargin) + 1)};
}

double TagRenderer::Implementation::LightOf(
    const Panel& panel, const Plane& plane, int u, int v, double behind) const {
  const std::array<Eigen::Vector2d, 4> corners = {
      plane.Meet(CornerRay(u, v).cast<double>()),
      plane.Meet(CornerRay(u + 1, v).cast<double>()),
      plane.Meet(CornerRay(u + 1, v + 1).cast<double>()),
      plane.Meet(CornerRay(u, v + 1).cast<double>())};
  std::array<Eigen::Vector2d, 4> pixel;  // in cells
  for (int i = 0; i < 4; ++i) {
    if (!corners[i].allFinite()) return behind;
    pixel[i] = panel.InCells(corners[i]);
  }
  Eigen::Array2d low = pixel[0].array(), high = low;
  for (const Eigen::Vector2d& corner : pixel) {
    low = low.min(corner.array());
    high = high.max(corner.array());
  }
  const int last = panel.num_cells() - 1;
  if ((low >= last + 1.0).any() || (high <= 0.0).any()) return behind;
  const Eigen::Array2i first_cell = low.max(0.0).cast<int>();
  const Eigen::Array2i last_cell = high.min(last).cast<int>();

  // Straight lines stay straight from tag to pixel, as far as the lens bends them within one: each
  // cell has the share of the pixel that its area in the tag plane has.
  double white = 0.0, covered = 1.0;
  if (low.minCoeff() >= 0.0 && (first_cell == last_cell).all()) {
    white = panel.WhiteOf(first_cell.x(), first_cell.y());
  } else {
    const double area = AreaOf(pixel);
    covered = 0.0;
    for (int row = first_cell.y(); row <= last_cell.y(); ++row) {
      for (int column = first_cell.x(); column <= last_cell.x(); ++column) {
        const Eigen::Vector2d cell(column, row);
        const double share = AreaWithin(pixel, cell, cell + Eigen::Vector2d::Ones()) / area;
        covered += share;
        white += share * panel.WhiteOf(column, row);
      }
    }
    if (covered == 0.0) return behind;
  }
  const double brightness = view.black * covered + white * (view.white - view.black);
  const double distance = plane.DistanceOf(0.5 * (corners[0] + corners[2]));
  return covered * Seen(brightness / covered, distance) + (1.0 - covered) * behind;
}

void TagRenderer::Implementation::DrawPanel(const Panel& panel,
                                            std::span<const Pose> world_from_camera,
                                            std::vector<float>* light) const {
  std::vector<Plane> planes;
  for (const Pose& pose : world_from_camera) {
    planes.emplace_back(panel.marker.world_from_tag.Inverse() * pose);
    if (!planes.back().IsSeenFromAhead()) return;
  }
  const PixelBox box = BoxOf(panel, world_from_camera);
  for (int v = box.v_from; v < box.v_to; ++v) {
    for (int u = box.u_from; u < box.u_to; ++u) {
      float& pixel = (*light)[static_cast<std::size_t>(v) * camera.width + u];
      double sum = 0.0;
      for (const Plane& plane : planes) {
        sum += LightOf(panel, plane, u, v, pixel);
      }
      pixel = static_cast<float>(sum / static_cast<double>(planes.size()));
    }
  }
}

void TagRenderer::Implementation::Vignette(std::vector<float>* light) const {
  if (view.vignetting == 0.0) return;
  const double u_most = std::max(camera.cx, camera.width - 1 - camera.cx);
  const double v_most = std::max(camera.cy, camera.height - 1 - camera.cy);
  const double most = u_most * u_most + v_most * v_most;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double du = u - camera.cx, dv = v - camera.cy;
      (*light)[static_cast<std::size_t>(v) * camera.width + u] *=
          static_cast<float>(1.0 - view.vignetting * (du * du + dv * dv) / most);
    }
  }
}

TagRenderer::TagRenderer(const CameraModel& camera, const MarkerMap& map, const WaterView& view) {
  if (const auto problems = view.Problems(); !problems.empty()) {
    throw InputError(fmt::format("rendered view: {}.", fmt::join(problems, "; ")));
  }
  auto made = std::make_unique<Implementation>();
  made->camera = camera;
  made->view = view;
  made->largest_angle = LargestAngle(camera);
  for (const Marker& marker : map.markers) {
    made->panels.emplace_back(marker, PatternOf(marker.family, marker.id));
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int v = 0; v <= camera.height; ++v) {
    for (int u = 0; u <= camera.width; ++u) {
      const auto ray = RayOf(camera, {u - 0.5, v - 0.5}, made->largest_angle);
      made->rays.push_back(ray ? Eigen::Vector3f(ray->cast<float>())
                               : Eigen::Vector3f::Constant(nan));
    }
  }
  implementation_ = std::move(made);
}

TagRenderer::~TagRenderer() = default;
TagRenderer::TagRenderer(TagRenderer&&) noexcept = default;
TagRenderer& TagRenderer::operator=(TagRenderer&&) noexcept = default;

GrayImage TagRenderer::Render(std::span<const Pose> world_from_camera, std::uint64_t seed) const {
  CHECK(!world_from_camera.empty());
  const Implementation& it = *implementation_;
  const Pose& middle = world_from_camera[world_from_camera.size() / 2];
  std::vector<float> light;
  it.DrawWall(middle, &light);

  // The farthest first, so that nearer markers hide it.
  std::vector<const Panel*> panels;
  for (const Panel& panel : it.panels) panels.push_back(&panel);
  const auto distance = [&](const Panel* panel) {
    return (panel->marker.world_from_tag.translation - middle.translation).norm();
  };
  std::stable_sort(panels.begin(), panels.end(), [&](const Panel* a, const Panel* b) {
    return distance(a) > distance(b);
  });
  for (const Panel* panel : panels) it.DrawPanel(*panel, world_from_camera, &light);

  if (it.view.blur > 0.0) {
    cv::Mat matrix(it.camera.height, it.camera.width, CV_32F, light.data());
    cv::GaussianBlur(matrix, matrix, {}, it.view.blur, it.view.blur, cv::BORDER_REPLICATE);
  }
  it.Vignette(&light);
  return Expose(it.camera.width, it.camera.height, light, it.view.noise, it.view.shot_noise, seed);
}

}  // namespace fathom
