// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/detection_filter.h"

#include <vector>

#include "rendered_scene.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TagSighting Sighting(int id, int hamming = 0, double shift = 0.0) {
  TagSighting sighting;
  sighting.family = "tag36h11";
  sighting.tag_id = id;
  sighting.hamming = hamming;
  sighting.corners = {Eigen::Vector2d(10.0 + shift, 30.0),
                      Eigen::Vector2d(30.0 + shift, 31.0),
                      Eigen::Vector2d(29.0 + shift, 11.0),
                      Eigen::Vector2d(11.0 + shift, 10.0)};
  return sighting;
}

MarkerMap TwoMarkers() {
  MarkerMap map = OneMarker("tag36h11", 4, 0.2);
  map.markers.push_back(map.markers[0]);
  map.markers[1].id = 2;
  return map;
}

TEST(DetectionsAmong, KeepsTheMarkersOfTheMapInTheOrderOfTheirIds) {
  const std::vector<TagSighting> seen = {Sighting(4), Sighting(2)};
  const FrameDetections frame = DetectionsAmong(seen, TwoMarkers(), 0, 1.5);
  ASSERT_EQ(frame.detections.size(), 2u);
  EXPECT_TRUE(frame.unused.empty());
  EXPECT_EQ(frame.detections[0].tag_id, 2);
  EXPECT_EQ(frame.detections[1].tag_id, 4);
  EXPECT_EQ(frame.detections[0].time, 1.5);
  EXPECT_EQ(frame.detections[0].corners[2], Eigen::Vector2d(29.0, 11.0));
}

TEST(DetectionsAmong, SaysWhyEachOtherIsRejected) {
  TagSighting other_family = Sighting(2);
  other_family.family = "tag25h9";
  TagSighting mirrored = Sighting(2);
  std::swap(mirrored.corners[0], mirrored.corners[1]);
  std::swap(mirrored.corners[2], mirrored.corners[3]);
  struct Case {
    TagSighting sighting;
    SightingFault expected;
  };
  for (const Case& it : {Case{Sighting(2, 1), SightingFault::kWrongBits},
                         Case{Sighting(9), SightingFault::kNotInMap},
                         Case{other_family, SightingFault::kNotInMap},
                         Case{mirrored, SightingFault::kDegenerate}}) {
    const std::vector<TagSighting> seen = {it.sighting, Sighting(4)};
    const FrameDetections frame = DetectionsAmong(seen, TwoMarkers(), 0, 2.0);
    ASSERT_EQ(frame.detections.size(), 1u) << Describe(it.expected);
    EXPECT_EQ(frame.detections[0].tag_id, 4);
    ASSERT_EQ(frame.unused.size(), 1u);
    EXPECT_EQ(frame.unused[0].fault, it.expected);
    EXPECT_EQ(frame.unused[0].time, 2.0);
    EXPECT_EQ(frame.unused[0].sighting.tag_id, it.sighting.tag_id);
  }
}

TEST(DetectionsAmong, RejectsBothOfAMarkerThatIsSeenTwice) {
  const std::vector<TagSighting> seen = {Sighting(4), Sighting(4, 0, 100.0), Sighting(2)};
  const FrameDetections frame = DetectionsAmong(seen, TwoMarkers(), 0, 0.0);
  ASSERT_EQ(frame.detections.size(), 1u);
  EXPECT_EQ(frame.detections[0].tag_id, 2);
  ASSERT_EQ(frame.unused.size(), 2u);
  EXPECT_EQ(frame.unused[0].fault, SightingFault::kSeveralSeen);
  EXPECT_EQ(frame.unused[1].fault, SightingFault::kSeveralSeen);
}

TEST(DetectionsAmong, IsNotConfusedByASecondOneWithWrongBits) {
  const std::vector<TagSighting> seen = {Sighting(4), Sighting(4, 1, 100.0)};
  const FrameDetections frame = DetectionsAmong(seen, TwoMarkers(), 0, 0.0);
  ASSERT_EQ(frame.detections.size(), 1u);
  EXPECT_EQ(frame.detections[0].corners[0].x(), 10.0);
  EXPECT_EQ(DetectionsAmong(seen, TwoMarkers(), 1, 0.0).detections.size(), 0u);
}

}  // namespace
}  // namespace fathom
