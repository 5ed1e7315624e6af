// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/moved_markers.h"

#include "fathom/marker_trajectory/marker_trajectory.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "synthetic_views.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

constexpr int kNumFrames = 120;

// What happens to one of the four markers of a record.
struct Move {
  int tag_id = 0;
  int frame = 0;  // the first behind it
  Eigen::Vector3d by = Eigen::Vector3d::Zero();
  double turn = 0.0;  // in the wall [rad]
};

// At any time but the first and last two seconds, any tag, by 2 to 30 cm along the wall and by up
// to half a radian.
Move DrawMove(std::mt19937* random) {
  std::uniform_int_distribution<int> tag(0, 3), frame(20, kNumFrames - 20);
  std::uniform_real_distribution<double> direction(0.0, 6.28), size(0.02, 0.3), turn(-0.5, 0.5);
  const double to = direction(*random), distance = size(*random);
  return {.tag_id = tag(*random),
          .frame = frame(*random),
          .by = distance * Eigen::Vector3d(0.0, std::cos(to), std::sin(to)),
          .turn = turn(*random)};
}

// Two in a hundred detections are false decodes, and one in ten is missing.
std::vector<Detection> Seen(const Move& move, std::mt19937* random) {
  const MarkerMap map = FourMarkers();
  MarkerMap moved = map;
  Pose& place = moved.markers[move.tag_id].world_from_tag;
  place.translation += move.by;
  place.rotation = place.rotation * Eigen::AngleAxisd(move.turn, Eigen::Vector3d::UnitZ());
  std::vector<Detection> all;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < kNumFrames; ++i) {
    const double t = 0.1 * i;
    for (Detection detection :
         ObserveCorners(SyntheticCamera(), i < move.frame ? map : moved, CameraPoseAt(t, 0.0), t)) {
      if (uniform(*random) < 0.1) continue;
      if (uniform(*random) < 0.02) PutElsewhere(300.0, random, &detection);
      all.push_back(detection);
    }
  }
  AddNoise(kCornerSigma, random, &all);
  return all;
}

MarkerTrack TrackOf(const std::vector<Detection>& detections) {
  return TrackMarkers(detections, SyntheticCamera(), FourMarkers(), kBodyFromCamera);
}

TEST(MovedMarkers, AreFoundWithTimeAndDistance) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Move move = DrawMove(&random);
    const MarkerTrack track = TrackOf(Seen(move, &random));
    ASSERT_EQ(track.moved_markers.size(), 1);
    const MovedMarker& found = track.moved_markers.front();
    EXPECT_EQ(found.tag_id, move.tag_id);
    // A tenth of the detections is missing, and one may be a false decode.
    EXPECT_NEAR(found.time, 0.1 * move.frame, 0.35);
    EXPECT_NEAR(found.distance, move.by.norm(), 4.0 * found.distance_std);
    EXPECT_LT(found.distance_std, 0.003);
    EXPECT_NEAR(found.angle, std::abs(move.turn), 0.02);
  }
}

// At most 5 %: with thirty logs, one.
TEST(MovedMarkers, AreNotFoundWhereNoneMoved) {
  int num_alarms = 0;
  for (unsigned seed = 101; seed <= 130; ++seed) {
    std::mt19937 random(seed);
    num_alarms += TrackOf(Seen({.frame = kNumFrames}, &random)).moved_markers.empty() ? 0 : 1;
  }
  EXPECT_LE(num_alarms, 1);
}

TEST(MovedMarkers, AreTold) {
  std::mt19937 random(5);
  const MarkerTrack track =
      TrackOf(Seen({.tag_id = 2, .frame = 60, .by = {0.0, 0.06, 0.08}}, &random));
  ASSERT_EQ(track.moved_markers.size(), 1);
  const std::string text = RemarkOn(track.moved_markers.front());
  EXPECT_THAT(text, HasSubstr("Tag 2 sits 10 cm (± 0.0"));
  EXPECT_THAT(text, HasSubstr("elsewhere"));
  EXPECT_THAT(text, HasSubstr("from t = 6.0 s on"));
  EXPECT_TRUE(
      std::ranges::any_of(track.remarks, [&](const Remark& one) { return one.text == text; }));
}

}  // namespace
}  // namespace fathom
