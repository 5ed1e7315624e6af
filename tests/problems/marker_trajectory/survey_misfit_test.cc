// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/survey_misfit.h"

#include "fathom/marker_trajectory/marker_trajectory.h"

#include <algorithm>
#include <string>
#include <vector>

#include "synthetic_views.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

class SurveyMisfit : public ::testing::Test {
 protected:
  std::string RemarkUnder(const CameraModel& camera, const MarkerMap& survey) const {
    const MarkerTrack track = TrackMarkers(record_.detections, camera, survey, kBodyFromCamera);
    EXPECT_TRUE(track.IsUsable()) << track.message;
    const std::string remark = RemarkOnSurveyMisfit(camera, record_.detections, track);
    const bool is_told =
        std::ranges::any_of(track.remarks, [&](const Remark& one) { return one.text == remark; });
    EXPECT_EQ(is_told, !remark.empty());
    return remark;
  }

  const SyntheticRecord record_ = MakeRecord(FourMarkers(), 300, 0.0, kCornerSigma, 6);
};

TEST_F(SurveyMisfit, IsNotFoundInARightSurvey) {
  EXPECT_EQ(RemarkUnder(SyntheticCamera(), FourMarkers()), "");
}

// The poses give way, so that another tag's corners may be further off than the wrong one's.
TEST_F(SurveyMisfit, NamesTheTagWhosePlaceIsWrong) {
  for (std::size_t wrong = 0; wrong < 4; ++wrong) {
    MarkerMap survey = FourMarkers();
    survey.markers[wrong].world_from_tag.translation += Eigen::Vector3d(0.05, 0.0, 0.0);
    EXPECT_THAT(RemarkUnder(SyntheticCamera(), survey),
                HasSubstr("A wrong position of tag " + std::to_string(survey.markers[wrong].id) +
                          " alone would explain this"));
  }
}

// A vehicle at rest may show the same picture again and again: no noise at all.
TEST_F(SurveyMisfit, IsFoundWithoutNoise) {
  std::vector<Detection> detections;
  for (int i = 0; i < 50; ++i) {
    for (Detection detection : record_.detections) {
      if (detection.time != record_.detections.front().time) break;
      detection.time += 0.1 * i;
      detections.push_back(detection);
    }
  }
  MarkerMap survey = FourMarkers();
  survey.markers[1].world_from_tag.translation += Eigen::Vector3d(0.0, 0.1, 0.0);
  const MarkerTrack track = TrackMarkers(detections, SyntheticCamera(), survey, kBodyFromCamera);
  ASSERT_TRUE(track.IsUsable()) << track.message;
  EXPECT_LT(track.corner_noise, 1e-6);
  EXPECT_NE(RemarkOnSurveyMisfit(SyntheticCamera(), detections, track), "");
}

TEST_F(SurveyMisfit, BlamesNoSingleTagForALens) {
  CameraModel camera = SyntheticCamera();
  camera.fy *= 1.1;
  EXPECT_THAT(RemarkUnder(camera, FourMarkers()),
              HasSubstr("No single tag's position explains this"));
}

}  // namespace
}  // namespace fathom
