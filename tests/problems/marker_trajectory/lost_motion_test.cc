// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/lost_motion.h"

#include "fathom/marker_trajectory/marker_trajectory.h"

#include <cmath>
#include <vector>

#include "synthetic_views.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

struct FoundSwing {
  LostMotion lost;         // as it is reckoned
  double truth = 0.0;      // one less the slope of found distance over true distance
  double truth_std = 0.0;  // of that slope
  std::vector<Remark> remarks;
};

// A swing between 2.6 and 3.4 m at 10 Hz.
FoundSwing SwingBefore(const MarkerMap& map, double tilt, double sigma, int num_frames = 1500) {
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
  return {.lost = LostMotionOf(record.detections, track),
          .truth = 1.0 - slope,
          .truth_std = std::sqrt(rest / (sxx - sx * sx / n)),
          .remarks = track.remarks};
}

// Without RemoveBias 1.7 % would be lost.
TEST(LostMotion, BoundsWhatIsLeftWhereASingleMarkerIsSeenFaceOn) {
  const FoundSwing found = SwingBefore(SingleMarker(), 0.0, 0.3, 3000);
  EXPECT_LT(std::abs(found.truth), found.lost.share + 2.0 * found.truth_std);
  EXPECT_LT(found.lost.share, 0.005);
  EXPECT_GT(found.lost.num_poses, 2000);
  ASSERT_TRUE(Holds(found.remarks, RemarkKind::kLostMotion));
  EXPECT_THAT(TextsOf(found.remarks),
              Contains(HasSubstr(" poses rest on a single marker whose tilt")));
}

TEST(LostMotion, IsNotToldOfWhereTheTiltIsKnown) {
  for (const FoundSwing& found : {SwingBefore(SingleMarker(), 0.0, 0.1, 3000),
                                  SwingBefore(SingleMarker(), 0.5, 0.3),
                                  SwingBefore(FourMarkers(), 0.0, 0.3, 300)}) {
    EXPECT_LT(std::abs(found.truth), 3.0 * found.truth_std);
    EXPECT_THAT(found.remarks, ::testing::IsEmpty());
  }
}

}  // namespace
}  // namespace fathom
