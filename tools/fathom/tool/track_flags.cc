// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/track_flags.h"

#include "fathom/base/input_error.h"

#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_bool(estimate_markers,
            false,
            "Estimate the positions of all markers except one, also of surveyed markers.");
DEFINE_int32(reference, -1, "The marker that then keeps its position. Default: the one seen most.");
DEFINE_double(gate,
              4.0,
              "Detections with larger errors than this, in corner sigmas, are outliers. Increase "
              "it if survey or lens are only roughly known.");
DEFINE_uint32(max_hamming, 0, "Bits of a tag's code that may be wrong: 0, 1 or 2.");
DEFINE_double(
    quad_decimate,
    1.0,
    "Look for tags in images smaller by this factor, 1.5 or a whole number to 16: faster.");
DEFINE_double(quad_sigma,
              0.0,
              "Blur images by this [px] before the detection, against strong noise.");
DEFINE_uint32(threads, 1, "Threads for the detection.");

namespace fathom {
namespace {

bool IsGiven(const char* flag) { return !gflags::GetCommandLineFlagInfoOrDie(flag).is_default; }

}  // namespace

TagDetectorOptions DetectorOptionsFromFlags() {
  TagDetectorOptions options;
  options.max_hamming = static_cast<int>(FLAGS_max_hamming);
  options.quad_decimate = FLAGS_quad_decimate;
  options.quad_sigma = FLAGS_quad_sigma;
  constexpr std::uint32_t kMostThreads = 256;
  if (FLAGS_threads < 1 || FLAGS_threads > kMostThreads) {
    throw InputError(
        fmt::format("--threads: is {}, expected 1 to {}.", FLAGS_threads, kMostThreads));
  }
  options.num_threads = static_cast<int>(FLAGS_threads);
  // The other options have the names of their flags.
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("--{}.", problems.front()));
  }
  return options;
}

void RequireNoDetectorFlags(const std::filesystem::path& folder) {
  for (const char* flag : {"max_hamming", "quad_decimate", "quad_sigma", "threads"}) {
    if (!IsGiven(flag)) continue;
    throw InputError(fmt::format(
        "--{}: is about the detection, but the track starts from {}, expected --from=images too.",
        flag,
        (folder / "detections.csv").string()));
  }
}

MarkerTrajectoryOptions TrajectoryOptionsFromFlags() {
  MarkerTrajectoryOptions options;
  options.estimate_surveyed_markers = FLAGS_estimate_markers;
  if (!(FLAGS_gate > 0.0)) {
    throw InputError(fmt::format("--gate: is {}, expected a number above 0.", FLAGS_gate));
  }
  options.pose_track.gate = FLAGS_gate;
  if (IsGiven("reference")) {
    if (!FLAGS_estimate_markers) {
      throw InputError(fmt::format(
          "--reference={}: stands without --estimate_markers, expected both: it is the marker that "
          "keeps its place while the others are estimated.",
          FLAGS_reference));
    }
    options.reference_id = FLAGS_reference;
  }
  return options;
}

void RequireReference(const MarkerTrajectoryOptions& options,
                      const MarkerMap& map,
                      const std::filesystem::path& tags_file) {
  if (!options.reference_id) return;
  std::vector<int> surveyed;
  for (const Marker& marker : map.markers) {
    if (marker.is_surveyed) surveyed.push_back(marker.id);
    if (marker.is_surveyed && marker.id == *options.reference_id) return;
  }
  throw InputError(fmt::format("--reference={}: is no surveyed tag of {}, expected one of {}.",
                               *options.reference_id,
                               tags_file.string(),
                               fmt::join(surveyed, ", ")));
}

}  // namespace fathom
