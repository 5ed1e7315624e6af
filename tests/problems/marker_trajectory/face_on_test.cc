// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/face_on.h"

#include <cmath>
#include <vector>

#include "synthetic_views.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

const Pose kBodyFromCamera = {Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5), {0.3, -0.1, 0.2}};

struct Lost {
  double share = 0.0;      // as it is computed
  double truth = 0.0;      // less one: the slope of found distance over true distance
  double truth_std = 0.0;  // of that slope
  std::vector<std::string> remarks;
};

// A swing between 2.6 and 3.4 m at 10 Hz.
Lost LostMotionOf(const MarkerMap& map, double tilt, double sigma, int num_frames = 1500) {
  const SyntheticRecord record = MakeRecord(map, num_frames, tilt, sigma, 31);
  const MarkerTrack track =
      TrackMarkers(record.detections, SyntheticCamera(), map, kBodyFromCamera);
  EXPECT_EQ(track.world_from_camera.size(), record.time.size());
  const double n = num_frames;
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
  for (size_t i = 0; i < track.world_from_camera.size(); ++i) {
    const double x = record.world_from_camera[i].translation.x();
    const double y = track.world_from_camera[i].pose.translation.x();
    sx += x, sy += y, sxx += x * x, sxy += x * y, syy += y * y;
  }
  const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  const double rest = (syy - sy * sy / n - slope * (sxy - sx * sy / n)) / n;
  return {.share = LostMotionShare(record.detections, track),
          .truth = 1.0 - slope,
          .truth_std = std::sqrt(rest / (sxx - sx * sx / n)),
          .remarks = track.remarks};
}

// What is lost is the square of the tilt's noise: nine times less at a third of the noise.
TEST(LostMotion, IsThatOfTheTrackWhereAMarkerIsSeenFaceOn) {
  const Lost noisy = LostMotionOf(SingleMarker(), 0.0, 0.3);
  EXPECT_GT(noisy.truth, 5.0 * noisy.truth_std);  // there is something to find
  EXPECT_GT(noisy.share, 0.5 * noisy.truth);
  EXPECT_LT(noisy.share, noisy.truth + 3.0 * noisy.truth_std);
  EXPECT_THAT(noisy.remarks, Contains(HasSubstr("1500 poses rest on a single marker whose tilt")));

  const Lost clean = LostMotionOf(SingleMarker(), 0.0, 0.1);
  EXPECT_NEAR(clean.share, clean.truth, 3.0 * clean.truth_std + 0.2 * clean.share);
  EXPECT_THAT(clean.remarks, ::testing::IsEmpty());
}

TEST(LostMotion, IsSmallAndNotToldOfWhereTheTiltIsKnown) {
  for (const Lost& lost :
       {LostMotionOf(SingleMarker(), 0.5, 0.3), LostMotionOf(FourMarkers(), 0.0, 0.3, 300)}) {
    EXPECT_LT(lost.share, 0.002);
    EXPECT_LT(std::abs(lost.truth), 0.002 + 4.0 * lost.truth_std);
    EXPECT_THAT(lost.remarks, ::testing::IsEmpty());
  }
}

}  // namespace
}  // namespace fathom
