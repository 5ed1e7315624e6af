// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/tags_file.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::StartsWith;

constexpr char kTags[] =
    "family: tag36h11\n"
    "tags:\n"
    "  - {id: 4, size: 0.16, world_from_tag: {position: [2, -1, 0.5], quaternion: [0, 0, 0.6, "
    "0.8]}}\n"
    "  - {id: 5, size: 0.08, family: tag25h9}\n";

std::string Error(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return ErrorFrom([&] { ParseTagsFile("tags.yaml", text.replace(at, from.size(), to)); });
}

TEST(TagsFile, ReadsSizesFamiliesAndPlaces) {
  const MarkerMap map = ParseTagsFile("tags.yaml", kTags);
  ASSERT_EQ(map.markers.size(), 2u);
  const Marker& first = map.markers[0];
  EXPECT_EQ(first.id, 4);
  EXPECT_EQ(first.size, 0.16);
  EXPECT_EQ(first.family, "tag36h11");
  EXPECT_TRUE(first.is_surveyed);
  // 0.6, 0.8 is a turn about z with cosine 0.8^2 - 0.6^2 and sine 2 * 0.6 * 0.8.
  EXPECT_TRUE((first.world_from_tag * Eigen::Vector3d(1.0, 0.0, 0.0))
                  .isApprox(Eigen::Vector3d(2.28, -0.04, 0.5)));
  EXPECT_EQ(map.markers[1].family, "tag25h9");
  EXPECT_FALSE(map.markers[1].is_surveyed);
}

TEST(TagsFile, ReadsBackWhatItWrites) {
  MarkerMap map = ParseTagsFile("tags.yaml", kTags);
  map.markers[0].world_from_tag.translation.x() = 0.1 + 0.2;
  const MarkerMap again = ParseTagsFile("again.yaml", FormatTagsFile(map));
  ASSERT_EQ(again.markers.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(again.markers[i].id, map.markers[i].id);
    EXPECT_EQ(again.markers[i].size, map.markers[i].size);
    EXPECT_EQ(again.markers[i].family, map.markers[i].family);
    EXPECT_EQ(again.markers[i].is_surveyed, map.markers[i].is_surveyed);
    EXPECT_EQ(again.markers[i].world_from_tag.translation,
              map.markers[i].world_from_tag.translation);
    EXPECT_TRUE(again.markers[i].world_from_tag.rotation.isApprox(
        map.markers[i].world_from_tag.rotation, 1e-15));
  }
}

TEST(TagsFile, RefusesWhatItCannotUse) {
  EXPECT_EQ(
      Error(kTags, "id: 5", "id: 4"),
      "tags.yaml:4: key 'tags[1].id' is 4, which stands above already, expected each id once, "
      "also across families: detections tell tags apart by id alone.");
  EXPECT_EQ(Error(kTags, "id: 5", "id: -5"),
            "tags.yaml:4: key 'tags[1].id' is -5, expected a number from 0 on.");
  EXPECT_EQ(Error(kTags, "id: 4", "id: 587"),
            "tags.yaml:3: key 'tags[0].id' is 587, expected one of tag36h11: it has the ids from 0 "
            "to 586.");
  EXPECT_EQ(Error(kTags, "id: 4", "id: 586"), "no error");
  EXPECT_EQ(Error(kTags, "tag36h11", "tag36h12"),
            "tags.yaml:1: key 'family' is 'tag36h12', expected one of tag16h5, tag25h9, tag36h10, "
            "tag36h11, tagCircle21h7, tagCircle49h12, tagCustom48h12, tagStandard41h12, "
            "tagStandard52h13.");
  EXPECT_EQ(Error(kTags, "family: tag36h11\n", ""),
            "tags.yaml:2: key 'tags[0].family' is missing, expected a text.");
  EXPECT_EQ(Error(kTags, "0.16", "160"),
            "tags.yaml:3: key 'tags[0].size' is 160, expected the side of the square in "
            "metres, above 0 and at most 20.");
  EXPECT_THAT(Error(kTags, "0.16", "0"), StartsWith("tags.yaml:3: key 'tags[0].size' is 0, "));
  EXPECT_EQ(Error(kTags, "0.8]", "0.9]"),
            "tags.yaml:3: key 'tags[0].world_from_tag.quaternion' has length 1.08167, expected a "
            "unit quaternion x, y, z, w (within 0.001).");
  EXPECT_EQ(
      Error(kTags, ", world_from_tag: {position: [2, -1, 0.5], quaternion: [0, 0, 0.6, 0.8]}", ""),
      "tags.yaml:2: key 'tags' holds no tag with a world_from_tag, expected at least one: it "
      "says where the world is. Give one of them the pose you want it to have.");
  EXPECT_THAT(Error(kTags, "size: 0.08", "sise: 0.08"),
              StartsWith("tags.yaml:4: key 'tags[1].size' is missing"));
}

}  // namespace
}  // namespace fathom
