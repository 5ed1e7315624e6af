// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Detection of tags in images of 2040 x 2040 px, against bare libapriltag with the same settings in
// the same run, image by image in turns, so that a busy machine slows both alike:
//
//   detection_bench
//
// `bare` is apriltag_detector_detect on libapriltag's own defaults but decimation 1; `same` is
// TagDetector with noise_margin 0, which asks the same of libapriltag; `followed` follows the sides
// of what `same` finds, as DetectTags() does; `default` is what fathom_track does: it passes over
// what is only noise, and follows the sides. Prints medians of CPU time; exit code 1 if `same` or
// `followed` takes 10 % more than `bare`.

#include "fathom/camera/camera_model.h"
#include "fathom/camera/tag_family.h"
#include "fathom/detect/edge_refinement.h"
#include "fathom/detect/tag_detector.h"
#include "fathom/film/tag_renderer.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <memory>
#include <vector>

extern "C" {
#include <apriltag/apriltag.h>
}

namespace fathom {
namespace {

constexpr int kSide = 2040;

CameraModel Camera() {
  CameraModel camera;
  camera.width = camera.height = kSide;
  camera.fx = camera.fy = 1500.0;
  camera.cx = camera.cy = 0.5 * (kSide - 1);
  return camera;
}

std::vector<GrayImage> Images(double noise) {
  MarkerMap map;
  for (int i = 0; i < 4; ++i) {
    Marker marker;
    marker.id = i;
    marker.size = 0.2 + 0.1 * i;
    marker.family = "tag36h11";
    marker.world_from_tag.translation = {i % 2 - 0.5, i / 2 - 0.5, 0.0};
    map.markers.push_back(marker);
  }
  WaterView view;
  view.noise = noise;
  view.attenuation = 0.1;
  const TagRenderer renderer(Camera(), map, view);
  std::vector<GrayImage> images;
  for (int i = 0; i < 3; ++i) {
    Pose pose;
    pose.translation = {0.1 * i, 0.0, -2.0 - 0.7 * i};
    images.push_back(renderer.Render(std::array{pose}, i + 1));
  }
  return images;
}

// CPU time of the process [ms].
template <typename Work>
double Time(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double Median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

// Finds tags and follows their sides; how many were followed.
int DetectAndFollow(const GrayImage& image, TagDetector* detector) {
  static const CameraModel camera = Camera();
  static const double largest_angle = LargestAngle(camera);
  int num_followed = 0;
  for (const TagSighting& tag : detector->Detect(image)) {
    if (FollowSides(image, camera, largest_angle, tag.corners)) ++num_followed;
  }
  return num_followed;
}

// Fathom's times over bare libapriltag's.
struct Ratios {
  double same = 0.0, followed = 0.0;
};

Ratios Compare(double noise) {
  const TagFamilyPtr family = CreateTagFamily("tag36h11");
  const std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> bare(
      apriltag_detector_create(), apriltag_detector_destroy);
  apriltag_detector_add_family_bits(bare.get(), family.get(), 1);
  bare->quad_decimate = 1.0F;
  TagDetectorOptions everywhere;
  everywhere.noise_margin = 0.0;
  TagDetector same({"tag36h11"}, everywhere);
  TagDetector usual({"tag36h11"});
  std::vector<double> bare_ms, same_ms, followed_ms, usual_ms;
  std::array<int, 4> num{};
  for (GrayImage& image : Images(noise)) {
    for (int turn = 0; turn < 5; ++turn) {
      bare_ms.push_back(Time([&] {
        image_u8_t view = {image.width, image.height, image.width, image.pixels.data()};
        zarray_t* found = apriltag_detector_detect(bare.get(), &view);
        num[0] += zarray_size(found);
        apriltag_detections_destroy(found);
      }));
      same_ms.push_back(Time([&] { num[1] += static_cast<int>(same.Detect(image).size()); }));
      followed_ms.push_back(Time([&] { num[2] += DetectAndFollow(image, &same); }));
      usual_ms.push_back(Time([&] { num[3] += DetectAndFollow(image, &usual); }));
    }
  }
  apriltag_detector_clear_families(bare.get());
  const Ratios ratios = {Median(same_ms) / Median(bare_ms), Median(followed_ms) / Median(bare_ms)};
  std::printf(
      "noise %.0f: bare %.1f ms, same %.1f ms (%.3f), followed %.1f ms (%.3f), default %.1f ms; "
      "%d, %d, %d, %d tags found\n",
      noise,
      Median(bare_ms),
      Median(same_ms),
      ratios.same,
      Median(followed_ms),
      ratios.followed,
      Median(usual_ms),
      num[0],
      num[1],
      num[2],
      num[3]);
  return ratios;
}

}  // namespace
}  // namespace fathom

int main() {
  double same = 0.0, followed = 0.0;
  for (const double noise : {0.0, 2.0, 5.0}) {
    const fathom::Ratios ratios = fathom::Compare(noise);
    same = std::max(same, ratios.same);
    followed = std::max(followed, ratios.followed);
  }
  std::printf("same / bare: at most %.3f, followed / bare: at most %.3f, expected below 1.1\n",
              same,
              followed);
  return std::max(same, followed) < 1.1 ? 0 : 1;
}
