// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/corner_noise.h"

#include "fathom/marker_trajectory/marker_trajectory.h"

#include <cmath>

#include "synthetic_views.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

struct Found {
  double corner_sigma, noise;
};

Found Track(const SyntheticRecord& record, const MarkerMap& map) {
  const MarkerTrack track =
      TrackMarkers(record.detections, SyntheticCamera(), map, kBodyFromCamera);
  EXPECT_TRUE(track.IsUsable()) << track.message;
  return {track.corner_sigma,
          CornerNoise(
              SyntheticCamera(), map, record.detections, track.pnp.views, track.world_from_camera)};
}

TEST(CornerNoise, IsThatOfTheCorners) {
  EXPECT_NEAR(Track(MakeRecord(SingleMarker(), 1500, 0.4, kCornerSigma, 4), SingleMarker()).noise,
              kCornerSigma,
              0.02 * kCornerSigma);
  EXPECT_NEAR(Track(MakeRecord(FourMarkers(), 300, 0.0, kCornerSigma, 5), FourMarkers()).noise,
              kCornerSigma,
              0.03 * kCornerSigma);
}

// A survey that is wrong by a centimetre or two is seen in every frame alike, or nearly: corner
// sigma is ten times the noise, and most of that is none.
TEST(CornerNoise, DoesNotCountWhatStays) {
  const SyntheticRecord record = MakeRecord(FourMarkers(), 300, 0.0, kCornerSigma, 6);
  MarkerMap survey = FourMarkers();
  survey.markers[1].world_from_tag.translation += Eigen::Vector3d(0.02, 0.02, 0.0);
  survey.markers[2].world_from_tag.translation += Eigen::Vector3d(0.0, -0.02, 0.01);
  const Found found = Track(record, survey);
  EXPECT_GT(found.corner_sigma, 4.0 * kCornerSigma);
  EXPECT_NEAR(found.noise, kCornerSigma, 0.1 * kCornerSigma);
}

// Frames seconds apart, and frames with other markers than those before, say nothing.
TEST(CornerNoise, IsUnknownWithoutNeighbours) {
  SyntheticRecord record = MakeRecord(FourMarkers(), 300, 0.0, kCornerSigma, 7);
  std::erase_if(record.detections, [&](const Detection& detection) {
    const int frame = static_cast<int>(std::lround(10.0 * (detection.time - 100.0)));
    return frame % 20 > 1 || (frame % 20 == 1 && detection.tag_id == 2);
  });
  EXPECT_TRUE(std::isnan(Track(record, FourMarkers()).noise));
}

}  // namespace
}  // namespace fathom
