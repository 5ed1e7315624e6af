// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/marker_conflicts.h"

#include "fathom/marker_trajectory/marker_trajectory.h"

#include <random>

#include "synthetic_views.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<MarkerConflict> ConflictsOf(const SyntheticRecord& record, const MarkerTrack& track) {
  return FindMarkerConflicts(record.detections, track);
}

// Markers 1 2 3 4 5 from west to east.
MarkerMap Panel() {
  MarkerMap map;
  const double places[5][2] = {{-0.6, 0.0}, {-0.3, 0.3}, {0.3, -0.1}, {0.9, 0.25}, {1.2, -0.2}};
  for (int i = 0; i < 5; ++i) {
    map.markers.push_back({.id = i + 1,
                           .size = 0.15,
                           .family = "tag36h11",
                           .world_from_tag = OnTheWall(places[i][0], places[i][1])});
  }
  return map;
}

// The survey has 4 and 5 elsewhere, by the same step. The camera sees 1, 2 and 3, then 3, 4 and 5,
// then 1, 2 and 3 again: nothing moves, and nothing tells whether 3 does.
TEST(MarkerConflicts, AreToldWithBothExplanations) {
  std::mt19937 random(2);
  SyntheticRecord record;
  for (int i = 0; i < 250; ++i) {
    const double east = i < 100 || i >= 230 ? -0.15 : 0.8;
    AddWallFrame(Panel(), 0.2 * i, WallPoseAt(0.2 * i, 1.6, east), 0.2, &random, &record);
  }
  MarkerMap survey = Panel();
  for (const int i : {3, 4}) survey.markers[i].world_from_tag.translation.y() += 0.15;
  const MarkerTrack track = TrackMarkers(record.detections, WallCamera(), survey, kBodyFromCamera);
  ASSERT_EQ(track.world_from_camera.size(), 250u);
  EXPECT_THAT(track.moved_markers, IsEmpty());
  const auto conflicts = ConflictsOf(record, track);
  ASSERT_EQ(conflicts.size(), 1u);
  EXPECT_EQ(conflicts[0].tag_id, 3);
  EXPECT_THAT(conflicts[0].against, ElementsAre(4, 5));
  EXPECT_THAT(conflicts[0].agrees_with, ElementsAre(1, 2));
  EXPECT_EQ(conflicts[0].num_frames, 130);
  EXPECT_THAT(
      TextsOf(track.remarks),
      Contains(AllOf(HasSubstr("Tag 3 contradicts tags 4, 5 whenever they are seen together (130 "
                               "frames), and agrees with tags 1, 2."),
                     HasSubstr("Either tag 3 was elsewhere in these frames, or tags 4, 5 are not "
                               "where tags.yaml says."))));
}

// Within the noise of the eleven or eight that agree. One of 600 chi-squares of 6 degrees of
// freedom is above 40 once in 4000 times.
TEST(MarkerConflicts, NameTheMarkersThatTheSurveyHasElsewhere) {
  const SyntheticRecord record = MakeWallRecord(TwelveMarkers(), 60, 1.3, 0.2, 1);
  for (const int num_wrong : {1, 4}) {
    const MarkerTrack track =
        TrackMarkers(record.detections, WallCamera(), WrongSurvey(num_wrong), kBodyFromCamera);
    ASSERT_EQ(track.world_from_camera.size(), 60u);
    for (int i = 0; i < 60; ++i) {
      const StampedPose& found = track.world_from_camera[i];
      const PoseIncrement error = StepBetween(found.pose, record.world_from_camera[i]);
      EXPECT_LT(error.dot(found.covariance.inverse() * error), 40.0);
    }
    EXPECT_THAT(track.moved_markers, IsEmpty());
    EXPECT_THAT(
        TextsOf(track.remarks),
        Contains(HasSubstr(num_wrong == 1 ? "not with tag 11: it is not where tags.yaml says."
                                          : "not with tags 8, 9, 10, 11: they are not where")));
  }
}

TEST(MarkerConflicts, AreNotFoundInARightSurvey) {
  const SyntheticRecord record = MakeWallRecord(TwelveMarkers(), 60, 1.3, 0.44, 1);
  const MarkerTrack track =
      TrackMarkers(record.detections, WallCamera(), TwelveMarkers(), kBodyFromCamera);
  EXPECT_THAT(ConflictsOf(record, track), IsEmpty());
  EXPECT_THAT(TextsOf(track.remarks), Not(Contains(HasSubstr("tags.yaml"))));
}

}  // namespace
}  // namespace fathom
