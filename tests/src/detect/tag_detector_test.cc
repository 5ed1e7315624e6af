// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/tag_detector.h"

#include "fathom/base/input_error.h"
#include "fathom/camera/tag_family.h"
#include "fathom/detect/detection_filter.h"
#include "fathom/detect/edge_refinement.h"
#include "fathom/film/tag_renderer.h"
#include "fathom/images/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "error_from.h"
#include "real_data.h"
#include "rendered_scene.h"
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace fathom {
namespace {

// Poses from which the marker of OneMarker is seen, by libapriltag's default order of corners.
std::vector<Pose> ManyPoses(int num, double nearest, double farthest, unsigned seed) {
  std::mt19937_64 bits(seed);
  const auto uniform = [&] { return (bits() >> 11) * 0x1p-53; };
  std::vector<Pose> poses;
  while (static_cast<int>(poses.size()) < num) {
    const double distance = nearest + (farthest - nearest) * uniform();
    const double tilt = 0.6 * uniform();
    const double about = 2.0 * EIGEN_PI * uniform();
    const Eigen::Quaterniond rotation =
        Eigen::AngleAxisd(tilt, Eigen::Vector3d(std::cos(about), std::sin(about), 0.0)) *
        Eigen::AngleAxisd(2.0 * EIGEN_PI * uniform(), Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d tag_in_camera(
        0.4 * distance * (uniform() - 0.5), 0.3 * distance * (uniform() - 0.5), distance);
    poses.push_back({rotation, -(rotation * tag_in_camera)});
  }
  return poses;
}

// Errors of detected corners, in pixels.
struct CornerErrors {
  int num_images = 0;
  int num_found = 0;
  Eigen::Vector2d bias = Eigen::Vector2d::Zero();
  double outward = 0.0;  // mean, away from the tag's centre
  double sigma = 0.0;    // per coordinate, about the exact projection
};

CornerErrors ErrorsOn(const CameraModel& camera,
                      const MarkerMap& map,
                      const WaterView& view,
                      const std::vector<Pose>& poses,
                      const TagDetectorOptions& options = {}) {
  const TagRenderer renderer(camera, map, view);
  TagDetector detector(map.Families(), options);
  CornerErrors errors;
  double square = 0.0;
  for (const Pose& pose : poses) {
    const auto truth = ObserveCorners(camera, map, pose);
    if (truth.size() != 1) continue;
    ++errors.num_images;
    for (const TagSighting& sighting :
         detector.Detect(renderer.Render(std::array{pose}, errors.num_images))) {
      if (sighting.tag_id != truth[0].tag_id || sighting.hamming != 0) continue;
      ++errors.num_found;
      Eigen::Vector2d centre = Eigen::Vector2d::Zero();
      for (const Eigen::Vector2d& corner : truth[0].corners) centre += 0.25 * corner;
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector2d error = sighting.corners[i] - truth[0].corners[i];
        errors.bias += error;
        errors.outward += error.dot((truth[0].corners[i] - centre).normalized());
        square += error.squaredNorm();
      }
    }
  }
  const int num_corners = 4 * errors.num_found;
  errors.bias /= num_corners;
  errors.outward /= num_corners;
  errors.sigma = std::sqrt(square / (2.0 * num_corners));
  return errors;
}

struct View {
  const char* name;
  CameraModel camera;
  double nearest, farthest;  // [m], for a tag of 0.4 m
  double noise, blur;
  double sigma;  // what was found, with a quarter on top
};

class Rendered : public testing::TestWithParam<View> {};

INSTANTIATE_TEST_SUITE_P(TagDetector,
                         Rendered,
                         testing::Values(View{"near", PlainCamera(), 1.0, 3.0, 2.0, 0.7, 0.05},
                                         View{"far", PlainCamera(), 3.0, 8.0, 2.0, 0.7, 0.06},
                                         View{"blurred", PlainCamera(), 1.0, 6.0, 2.0, 1.5, 0.06},
                                         View{"noisy", PlainCamera(), 1.0, 6.0, 6.0, 0.7, 0.065},
                                         View{"barrel", BarrelCamera(), 2.0, 6.0, 2.0, 0.7, 0.075}),
                         [](const auto& info) { return info.param.name; });

// The order of the corners and the half pixel are in this too: either one wrong would move every
// corner by half a pixel or a side. Poses are the same on every platform; 30 of them: a bias is
// known to sigma / 11.
TEST_P(Rendered, CornersAreFoundWithoutBias) {
  const View& it = GetParam();
  WaterView view;
  view.noise = it.noise;
  view.blur = it.blur;
  view.attenuation = 0.05;
  view.vignetting = 0.3;
  const CornerErrors errors = ErrorsOn(
      it.camera, OneMarker("tag36h11", 7, 0.4), view, ManyPoses(30, it.nearest, it.farthest, 5));
  std::printf("%d of %d found, bias (%.3f, %.3f), outward %.3f, sigma %.3f px\n",
              errors.num_found,
              errors.num_images,
              errors.bias.x(),
              errors.bias.y(),
              errors.outward,
              errors.sigma);
  EXPECT_GE(errors.num_images, 28);
  EXPECT_EQ(errors.num_found, errors.num_images);
  EXPECT_LT(errors.bias.cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT(std::abs(errors.outward), 0.03);
  EXPECT_LT(errors.sigma, it.sigma);
}

TEST(TagDetector, KnowsEveryFamily) {
  for (const std::string& family : TagFamilies()) {
    WaterView view;
    const CornerErrors errors =
        ErrorsOn(PlainCamera(), OneMarker(family, 3, 0.4), view, ManyPoses(5, 2.0, 3.0, 8));
    EXPECT_EQ(errors.num_found, errors.num_images) << family;
    EXPECT_GE(errors.num_images, 4) << family;
    EXPECT_LT(errors.sigma, 0.1) << family;
  }
}

TEST(TagDetector, FindsSeveralFamiliesAndSizesAtOnce) {
  MarkerMap map = OneMarker("tag36h11", 7, 0.4);
  Marker second = map.markers[0];
  second.id = 4;
  second.size = 0.2;
  second.family = "tag16h5";
  second.world_from_tag.translation = {0.5, 0.1, 0.0};
  map.markers.push_back(second);
  const Pose pose = LookingAt({0.2, 0.0, -1.6}, 0.1);
  const GrayImage image = TagRenderer(PlainCamera(), map).Render(std::array{pose}, 3);
  const auto truth = ObserveCorners(PlainCamera(), map, pose);
  ASSERT_EQ(truth.size(), 2u);
  TagDetector detector(map.Families());
  for (const Detection& expected : truth) {
    int num = 0;
    for (const TagSighting& sighting : detector.Detect(image)) {
      if (sighting.tag_id != expected.tag_id || sighting.hamming != 0) continue;
      EXPECT_EQ(sighting.family, map.Find(expected.tag_id)->family);
      for (int i = 0; i < 4; ++i) {
        EXPECT_LT((sighting.corners[i] - expected.corners[i]).norm(), 0.3) << expected.tag_id;
      }
      ++num;
    }
    EXPECT_EQ(num, 1) << expected.tag_id;
  }
}

TEST(TagDetector, FindsNothingWhereNothingIs) {
  TagDetector detector({"tag36h11"});
  EXPECT_TRUE(detector.Detect(GrayImage(320, 240, 120)).empty());
}

// A margin for noise must not cost a tag: of low contrast, or small.
TEST(TagDetector, LosesNoTagToTheMarginForNoise) {
  WaterView view;
  view.noise = 2.0;
  view.attenuation = 0.25;  // at 10 m, 8 % of the light comes through: 15 grey values of contrast
  TagDetectorOptions everywhere;
  everywhere.noise_margin = 0.0;
  const MarkerMap map = OneMarker("tag36h11", 7, 0.4);
  const auto poses = ManyPoses(20, 6.0, 10.0, 4);
  const CornerErrors with = ErrorsOn(PlainCamera(), map, view, poses);
  const CornerErrors without = ErrorsOn(PlainCamera(), map, view, poses, everywhere);
  EXPECT_GE(with.num_found, without.num_found);
  EXPECT_GT(without.num_found, 12);
}

TEST(TagDetector, RefusesWhatItCannotDo) {
  const auto message = [](const std::vector<std::string>& families,
                          const TagDetectorOptions& options) -> std::string {
    return ErrorFrom([&] { TagDetector detector(families, options); });
  };
  EXPECT_EQ(message({}, {}), "tag detector: no tag family, expected at least one.");
  EXPECT_EQ(message({"tag36h12"}, {}),
            "tag family 'tag36h12' is not known, expected one of tag16h5, tag25h9, tag36h10, "
            "tag36h11, tagCircle21h7, tagCircle49h12, tagCustom48h12, tagStandard41h12, "
            "tagStandard52h13.");
  TagDetectorOptions options;
  options.quad_decimate = 0.5;
  options.max_hamming = 3;
  EXPECT_EQ(message({"tag36h11"}, options),
            "tag detector: quad_decimate is 0.5, expected 1.5 or a whole number from 1 to 16; "
            "max_hamming is 3, expected 0, 1 or 2.");
}

// One marker from near, 90 px wide and more.
CornerErrors ErrorsFromNear(const TagDetectorOptions& options) {
  WaterView view;
  view.noise = 2.0;
  return ErrorsOn(
      PlainCamera(), OneMarker("tag36h11", 7, 0.4), view, ManyPoses(10, 1.0, 2.5, 5), options);
}

// libapriltag takes the whole part of other factors but keeps to the factor itself for the corners.
TEST(TagDetector, FindsTagsAtEveryFactorThatItDoesNotRefuse) {
  for (const double factor : {1.5, 2.0, 3.0}) {
    TagDetectorOptions options;
    options.quad_decimate = factor;
    const CornerErrors errors = ErrorsFromNear(options);
    EXPECT_EQ(errors.num_found, errors.num_images) << factor;
    EXPECT_LT(errors.sigma, 0.1) << factor;
  }
  for (const double factor : {1.2, 2.5, 3.7, 17.0}) {
    TagDetectorOptions options;
    options.quad_decimate = factor;
    EXPECT_EQ(options.Problems().size(), 1u) << factor;
  }
}

TEST(TagDetector, FindsTheSameInABlurredImageAndByTwoThreads) {
  TagDetectorOptions blurred;
  blurred.quad_sigma = 0.8;
  TagDetectorOptions threads;
  threads.num_threads = 2;
  const CornerErrors plain = ErrorsFromNear({});
  EXPECT_EQ(plain.num_found, plain.num_images);
  const CornerErrors by_two = ErrorsFromNear(threads);
  EXPECT_EQ(by_two.num_found, plain.num_found);
  EXPECT_DOUBLE_EQ(by_two.sigma, plain.sigma);
  const CornerErrors after_blur = ErrorsFromNear(blurred);
  EXPECT_EQ(after_blur.num_found, plain.num_found);
  EXPECT_LT(after_blur.sigma, 0.1);
}

// Factor by factor, around the limits: libapriltag reads and writes beyond smaller images, which
// ends the program or does not, as it happens; asan sees it.
TEST(TagDetector, FindsNothingInImagesTooSmallForATag) {
  for (const double factor : {1.0, 1.5, 2.0, 16.0}) {
    for (const double sigma : {0.0, 0.8, 16.0}) {
      TagDetectorOptions options;
      options.quad_decimate = factor;
      options.quad_sigma = sigma;
      TagDetector detector({"tag36h11"}, options);
      for (const int side : {1, 2, 3, 4, 5, 6, 16, 33, 49}) {
        EXPECT_TRUE(detector.Detect(GrayImage(100, side, 120)).empty()) << factor << " " << side;
        EXPECT_TRUE(detector.Detect(GrayImage(side, 100, 120)).empty()) << factor << " " << side;
      }
    }
  }
}

// The tag as it is printed, 16 pixels for a cell, with the cell in the middle turned over.
TEST(TagDetector, CorrectsAWrongBitWhereOneIsAllowed) {
  constexpr int kCell = 16;
  constexpr int kMargin = 3;  // [cells]
  TagPattern pattern = PatternOf("tag36h11", 7);
  std::uint8_t& bit = pattern.cells[pattern.width * (pattern.width / 2) + pattern.width / 2];
  bit = 255 - bit;
  const int width = (pattern.width + 2 * kMargin) * kCell;
  GrayImage image(width, width, 255);
  for (int v = 0; v < pattern.width * kCell; ++v) {
    for (int u = 0; u < pattern.width * kCell; ++u) {
      image.At(u + kMargin * kCell, v + kMargin * kCell) = pattern.At(u / kCell, v / kCell);
    }
  }
  TagDetectorOptions options;
  options.max_hamming = 1;
  const auto sightings = TagDetector({"tag36h11"}, options).Detect(image);
  ASSERT_EQ(sightings.size(), 1u);
  EXPECT_EQ(sightings[0].tag_id, 7);
  EXPECT_EQ(sightings[0].hamming, 1);
  const MarkerMap map = OneMarker("tag36h11", 7, 0.4);
  EXPECT_EQ(DetectionsAmong(sightings, map, 1, 0.0).detections.size(), 1u);
  EXPECT_EQ(DetectionsAmong(sightings, map, 0, 0.0).detections.size(), 0u);
}

// 48 714 codes of 52 bits, each with two of them wrong: 3 GB. In a process of its own, which then
// ends, with less than that.
TEST(TagDetectorDeathTest, SaysThatMemoryDoesNotSuffice) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs more address space than the limit";
#endif
  const auto construct = [] {
    const rlimit limit = {.rlim_cur = 1 << 30, .rlim_max = 1 << 30};
    setrlimit(RLIMIT_AS, &limit);
    TagDetectorOptions options;
    options.max_hamming = 2;
    try {
      TagDetector detector({"tagStandard52h13"}, options);
    } catch (const InputError& error) {
      std::fprintf(stderr, "%s", error.what());
      std::_Exit(1);
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(
      construct(),
      testing::ExitedWithCode(1),
      "tag detector: not enough memory for the codes of tagStandard52h13 with up to 2 wrong "
      "bits. Allow fewer .max_hamming.");
}

// Photos of libapriltag's own tests with reference corners.
class Photos : public OnRealData {
 protected:
  // Differences to the reference in each coordinate, of the tags that are found within 5 px. With
  // `num_followed` the corners are those of FollowSides(), as in fathom_track, and only tags whose
  // sides can be followed are compared. The photos come without a calibration: through a lens
  // without distortion sides are straight, whatever its focal length.
  std::vector<double> Differences(const TagDetectorOptions& options,
                                  int* num_tags,
                                  int* num_followed = nullptr) const {
    TagDetector detector({"tag36h11"}, options);
    std::vector<double> differences;
    *num_tags = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "apriltag_photos")) {
      if (entry.path().extension() != ".jpg") continue;
      const GrayImage image = ReadImage(entry.path());
      auto found = detector.Detect(image);
      if (num_followed != nullptr) found = Followed(image, found, num_followed);
      std::ifstream reference(std::filesystem::path(entry.path()).replace_extension(".txt"));
      for (std::string line; std::getline(reference, line);) {
        std::array<double, 8> c;
        int id = 0;
        if (std::sscanf(line.c_str(),
                        "%d, (%lf %lf), (%lf %lf), (%lf %lf), (%lf %lf)",
                        &id,
                        &c[0],
                        &c[1],
                        &c[2],
                        &c[3],
                        &c[4],
                        &c[5],
                        &c[6],
                        &c[7]) != 9) {
          continue;
        }
        ++*num_tags;
        // Every tag is id 0: the nearest one. The reference has libapriltag's half pixel.
        std::array<double, 8> nearest;
        double least = 5.0;
        for (const TagSighting& sighting : found) {
          std::array<double, 8> difference;
          double most = 0.0;
          for (int i = 0; i < 8; ++i) {
            difference[i] = std::abs(sighting.corners[i / 2][i % 2] + 0.5 - c[i]);
            most = std::max(most, difference[i]);
          }
          if (most < least) {
            least = most;
            nearest = difference;
          }
        }
        if (least < 5.0) differences.insert(differences.end(), nearest.begin(), nearest.end());
      }
    }
    std::sort(differences.begin(), differences.end());
    return differences;
  }

 private:
  static std::vector<TagSighting> Followed(const GrayImage& image,
                                           const std::vector<TagSighting>& found,
                                           int* num_followed) {
    CameraModel camera;
    camera.width = image.width;
    camera.height = image.height;
    camera.fx = camera.fy = image.width;
    camera.cx = 0.5 * (image.width - 1);
    camera.cy = 0.5 * (image.height - 1);
    std::vector<TagSighting> followed;
    for (TagSighting sighting : found) {
      const auto corners = FollowSides(image, camera, LargestAngle(camera), sighting.corners);
      if (!corners) continue;
      ++*num_followed;
      sighting.corners = *corners;
      followed.push_back(sighting);
    }
    return followed;
  }
};

TEST_F(Photos, AgreesWithTheReferenceCorners) {
  int num_tags = 0;
  const auto differences = Differences({}, &num_tags);
  ASSERT_EQ(num_tags, 47);
  EXPECT_GE(differences.size(), 8u * 45u);
  EXPECT_LT(differences[differences.size() / 2], 0.2);
}

// What fathom_track uses. 17 of the 47 tags have no side below the 20 px that can be followed.
TEST_F(Photos, AgreesWithTheReferenceCornersWhereSidesAreFollowed) {
  int num_tags = 0, num_followed = 0;
  const auto differences = Differences({}, &num_tags, &num_followed);
  std::printf("%d tags followed, %zu coordinates, median %.3f px, nine in ten below %.3f px\n",
              num_followed,
              differences.size(),
              differences[differences.size() / 2],
              differences[differences.size() * 9 / 10]);
  EXPECT_EQ(num_followed, 17);
  EXPECT_EQ(differences.size(), 8u * 17u);
  EXPECT_LT(differences[differences.size() / 2], 0.2);
}

// The reference was made without moving edges to the gradient, which on rendered tags, whose
// corners are known, has twice the errors.
TEST_F(Photos, GivesTheReferenceItselfWithoutRefinement) {
  TagDetectorOptions options;
  options.refine_edges = false;
  int num_tags = 0;
  const auto differences = Differences(options, &num_tags);
  EXPECT_GE(differences.size(), 8u * 46u);
  EXPECT_LT(differences[differences.size() / 2], 0.01);
  EXPECT_LT(differences[differences.size() * 9 / 10], 0.01);
}

}  // namespace
}  // namespace fathom
