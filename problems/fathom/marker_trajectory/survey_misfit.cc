// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/survey_misfit.h"

#include "fathom/marker_trajectory/bundle/bundle_adjustment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// What corner sigma may be under this noise [px]. Detection itself errs by a tenth of a pixel that
// stays while the vehicle does.
double LargestSigma(double corner_noise) {
  constexpr double kStays = 0.2;  // [px]
  return std::max(1.5 * corner_noise, std::hypot(corner_noise, kStays));
}

// Enough to tell which tag it is, and soon fitted.
std::vector<AdjustedFrame> SomeFramesOf(const MarkerTrack& track) {
  constexpr std::size_t kMost = 100;
  const std::size_t step = std::max<std::size_t>(1, track.world_from_camera.size() / kMost);
  std::vector<AdjustedFrame> frames;
  for (std::size_t i = 0; i < track.world_from_camera.size(); i += step) {
    const TrackedView& view = track.pnp.views[i];
    frames.push_back({track.world_from_camera[i].pose, view.detections, view.pose.noise_scale});
  }
  return frames;
}

struct Suspect {
  int id = -1;
  double corner_sigma = 0.0;  // with its place free [px]
};

// The tag whose place, if it were free, would leave least.
Suspect WorstTag(const CameraModel& camera,
                 std::span<const Detection> detections,
                 const MarkerTrack& track) {
  const std::vector<AdjustedFrame> frames = SomeFramesOf(track);
  std::set<int> seen;
  for (const AdjustedFrame& frame : frames) {
    for (const int i : frame.detections) seen.insert(detections[i].tag_id);
  }
  Suspect worst;
  for (const int id : seen) {
    const auto fit = AdjustBundle(
        camera, track.map, {id}, detections, frames, {.corner_sigma = track.corner_sigma});
    const bool is_less = worst.id < 0 || fit.corner_sigma < worst.corner_sigma;
    if (fit.is_usable && is_less) worst = {id, fit.corner_sigma};
  }
  return worst;
}

}  // namespace

bool IsSurveyInDoubt(const MarkerTrack& track) {
  return track.corner_sigma > LargestSigma(track.corner_noise);
}

std::string RemarkOnSurveyMisfit(const CameraModel& camera,
                                 std::span<const Detection> detections,
                                 const MarkerTrack& track) {
  if (!IsSurveyInDoubt(track)) return "";
  const Suspect worst = WorstTag(camera, detections, track);
  const bool is_one_tag = worst.id >= 0 && worst.corner_sigma < LargestSigma(track.corner_noise);
  return fmt::format(
      "The corners disagree with the given tags and lens by {:.2g} px (corner sigma), of which "
      "{:.2g} px is noise from frame to frame. The errors of the poses are larger than their "
      "standard deviations. {}",
      track.corner_sigma,
      track.corner_noise,
      is_one_tag
          ? fmt::format("A wrong position of tag {} alone would explain this, with {:.2g} px "
                        "left. Measure it again, or remove its world_from_tag from tags.yaml to "
                        "have it estimated.",
                        worst.id,
                        worst.corner_sigma)
          : std::string("No single tag's position explains this. The lens, the size of the tags "
                        "or the positions of several tags differ from their files."));
}

}  // namespace fathom
