// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/marker_remarks.h"

#include "fathom/marker_trajectory/lost_motion.h"
#include "fathom/marker_trajectory/marker_conflicts.h"
#include "fathom/marker_trajectory/moved_markers.h"
#include "fathom/marker_trajectory/survey_misfit.h"

#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {

std::vector<Remark> RemarksOn(const MarkerTrack& track,
                              const std::optional<int>& reference,
                              std::span<const Detection> detections,
                              const CameraModel& camera) {
  std::vector<Remark> remarks;
  const auto add = [&](std::string text, RemarkKind kind = RemarkKind::kDetections) {
    if (!text.empty()) remarks.push_back({kind, std::move(text)});
  };
  if (reference) {
    add(fmt::format("Tag {} defines the world frame. The other tags are estimated.", *reference));
  }
  if (!track.refuted_ids.empty()) {
    add(
        fmt::format("Not used, because no position agrees with the frames that show them: tags "
                    "{}. Did they move?",
                    fmt::join(track.refuted_ids, ", ")));
  }
  if (!track.unplaced_ids.empty()) {
    add(fmt::format("Not used, because never seen together with a tag of known position: tags {}.",
                    fmt::join(track.unplaced_ids, ", ")));
  }
  for (const MovedMarker& moved : track.moved_markers) add(RemarkOn(moved));
  for (std::string& one : RemarksOn(FindMarkerConflicts(detections, track))) add(std::move(one));
  for (std::string& loss : RemarksOn(track.pnp, detections)) add(std::move(loss));
  add(RemarkOnSurveyMisfit(camera, detections, track));
  add(RemarkOnLostMotion(detections, track), RemarkKind::kLostMotion);
  return remarks;
}

}  // namespace fathom
