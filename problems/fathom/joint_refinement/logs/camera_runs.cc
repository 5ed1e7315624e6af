// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/logs/camera_runs.h"

#include <algorithm>

namespace fathom {

CameraRuns CutIntoRuns(std::span<const Detection> detections,
                       const MarkerTrack& track,
                       double start,
                       std::span<const TimeInterval> held_out) {
  const auto is_held_out = [&](double t) {
    return std::any_of(held_out.begin(), held_out.end(), [t](const TimeInterval& interval) {
      return interval.Contains(t);
    });
  };
  CameraRuns cut;
  std::vector<CameraRun>& runs = cut.runs;
  bool was_held_out = false;
  double last = 0.0;
  for (std::size_t k = 0; k < track.world_from_body.size(); ++k) {
    const TrackedView& view = track.pnp.views[k];
    if (view.time < start) {
      ++cut.num_early;
      continue;
    }
    const bool is_silent = !runs.empty() && view.time - last > CameraRuns::kLongestGap;
    if (is_silent) ++cut.num_silences;
    last = view.time;
    if (is_held_out(view.time)) {
      ++cut.num_held_out;
      was_held_out = true;
      continue;
    }
    if (runs.empty() || is_silent || was_held_out) runs.emplace_back();
    was_held_out = false;
    CameraRun& run = runs.back();
    run.time.push_back(view.time);
    run.world_from_body.push_back(track.world_from_body[k].pose);
    auto& seen = run.detections.emplace_back();
    for (const int i : view.detections) seen.push_back(detections[i]);
  }
  std::erase_if(runs, [&](const CameraRun& run) {
    if (run.time.size() >= CameraRuns::kFewestFrames) return false;
    ++cut.num_short_runs;
    cut.num_in_short_runs += static_cast<int>(run.time.size());
    return true;
  });
  return cut;
}

}  // namespace fathom
