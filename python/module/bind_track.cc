// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/exists.h"
#include "fathom/base/files/temporary.h"
#include "fathom/camera/detections_file.h"
#include "fathom/detect/detect_tags.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/tool/track_input.h"
#include "fathom/tool/track_output.h"
#include "fathom/tool/track_summary.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "module/arguments.h"
#include "module/arrays.h"
#include "module/bindings.h"
#include "module/logs_argument.h"
#include "module/pose_path.h"
#include "module/python_words.h"
#include "module/tell.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

namespace fathom {

namespace py = pybind11;

namespace {

namespace fs = std::filesystem;

struct TrackArguments {
  std::optional<std::string> from;  // "images", "detections"
  bool is_detector_named = false;   // an option of the detection was given
  TagDetectorOptions detector;
  MarkerTrajectoryOptions trajectory;
};

struct TrackedInPython {
  TrackInput input;
  MarkerTrack track;
  TrackSummary summary;

  // Two poses make a pose.csv, as fathom_track has it.
  bool IsUsable() const { return track.world_from_body.size() >= 2; }
  std::string Message() const {
    if (IsUsable() || !track.IsUsable()) return track.message;
    return "a single frame has a pose, expected two at least.";
  }
};

// Names the option as Python has it.
bool StartsFromDetections(const fs::path& folder, const std::optional<std::string>& from) {
  const bool has_detections = Exists(folder / "detections.csv");
  if (!from) return has_detections;
  if (*from != "images" && *from != "detections") {
    throw InputError(fmt::format("from_: is '{}', expected images or detections.", *from));
  }
  if (*from == "detections" && !has_detections) {
    throw InputError(fmt::format("{}: holds no detections.csv. Leave out from_.", folder.string()));
  }
  return *from == "detections";
}

void RequireSurveyed(const std::optional<int>& reference,
                     const MarkerMap& map,
                     const fs::path& folder) {
  if (!reference) return;
  std::vector<int> surveyed;
  for (const Marker& marker : map.markers) {
    if (marker.is_surveyed) surveyed.push_back(marker.id);
  }
  if (std::ranges::find(surveyed, *reference) != surveyed.end()) return;
  throw InputError(fmt::format("reference: is {}, no surveyed tag of {}, expected one of {}.",
                               *reference,
                               (folder / "tags.yaml").string(),
                               fmt::join(surveyed, ", ")));
}

TrackedInPython TrackFolder(const fs::path& folder, TrackArguments arguments) {
  const bool from_detections = StartsFromDetections(folder, arguments.from);
  if (from_detections && arguments.is_detector_named) {
    throw InputError(fmt::format(
        "max_hamming, quad_decimate, quad_sigma, threads: are about the detection, but the track "
        "starts from {}, expected from_=\"images\" too.",
        (folder / "detections.csv").string()));
  }
  TrackedInPython result = {ReadTrackInput(folder, !from_detections), {}, {}};
  TrackInput& input = result.input;
  const CameraRig& rig = input.rig;
  RequireSurveyed(arguments.trajectory.reference_id, rig.map, folder);
  if (from_detections) {
    input.name = (folder / "detections.csv").string();
    input.detections = DetectionsOf(*input.log.detections);
  } else {
    const auto frames = input.Frames();
    input.name = frames->name();
    input.images = DetectTags(*frames, rig.camera, rig.map, arguments.detector);
    input.detections = input.images->detections;
    arguments.trajectory.pose_track.frame_times = input.images->frame_times;
  }
  arguments.trajectory.pose_track.name = input.name;
  result.track = TrackMarkers(
      input.detections, rig.camera, rig.map, rig.body_from_camera, arguments.trajectory);
  if (result.IsUsable()) RequireOneClock(input, result.track);
  result.summary =
      Summarize(input.log.name, input.images, input.detections, rig.camera, rig.map, result.track);
  return result;
}

// A path, or a Log that was opened from one.
fs::path FolderOfArgument(const py::object& log) {
  if (!py::isinstance<OpenedLog>(log)) return PathOf(log);
  const auto& opened = log.cast<const OpenedLog&>();
  if (!opened.is_of_arrays) return opened.log.path;
  throw InputError("log: is of arrays, expected a log folder with images or detections.csv.");
}

TrackedInPython TrackInPython(const py::object& log,
                              const std::optional<std::string>& from,
                              bool estimate_markers,
                              const std::optional<int>& reference,
                              double gate,
                              const std::optional<int>& max_hamming,
                              const std::optional<double>& quad_decimate,
                              const std::optional<double>& quad_sigma,
                              const std::optional<int>& threads) {
  TrackArguments arguments;
  arguments.from = from;
  arguments.is_detector_named = max_hamming || quad_decimate || quad_sigma || threads;
  TagDetectorOptions& detector = arguments.detector;
  detector.max_hamming = max_hamming.value_or(detector.max_hamming);
  detector.quad_decimate = quad_decimate.value_or(detector.quad_decimate);
  detector.quad_sigma = quad_sigma.value_or(detector.quad_sigma);
  detector.num_threads = threads.value_or(1);
  constexpr int kMostThreads = 256;
  if (detector.num_threads < 1 || detector.num_threads > kMostThreads) {
    throw InputError(
        fmt::format("threads: is {}, expected 1 to {}.", detector.num_threads, kMostThreads));
  }
  if (const auto problems = detector.Problems(); !problems.empty()) {
    throw InputError(problems.front() + ".");
  }
  if (!(gate > 0.0)) {
    throw InputError(fmt::format("gate: is {}, expected a number above 0.", gate));
  }
  if (reference && !estimate_markers) {
    throw InputError(
        fmt::format("reference: is {} without estimate_markers, expected both: it is the marker "
                    "that keeps its place while the others are estimated.",
                    *reference));
  }
  arguments.trajectory.pose_track.gate = gate;
  arguments.trajectory.estimate_surveyed_markers = estimate_markers;
  arguments.trajectory.reference_id = reference;
  const fs::path folder = FolderOfArgument(log);
  const py::gil_scoped_release release;
  return TrackFolder(folder, std::move(arguments));
}

void RequireUsable(const TrackedInPython& result) {
  if (!result.IsUsable()) throw InputError("no usable trajectory: " + result.Message());
}

PosePath BodyPath(const TrackedInPython& result) {
  RequireUsable(result);
  return {result.track.world_from_body};
}

PosePath CameraPath(const TrackedInPython& result) {
  RequireUsable(result);
  return {result.track.world_from_camera};
}

// The columns of detections.csv.
py::dict DictOfDetections(const TrackedInPython& result) {
  constexpr std::array kCorners = {"u0", "v0", "u1", "v1", "u2", "v2", "u3", "v3"};
  std::vector<double> time, tag_id;
  std::array<std::vector<double>, kCorners.size()> pixels;
  for (const Detection& detection : result.input.detections) {
    time.push_back(detection.time);
    tag_id.push_back(detection.tag_id);
    for (std::size_t k = 0; k < kCorners.size(); ++k) {
      pixels[k].push_back(detection.corners[k / 2][static_cast<Eigen::Index>(k % 2)]);
    }
  }
  py::dict columns;
  columns["t"] = ArrayOf(time);
  columns["tag_id"] = ArrayOf(tag_id);
  for (std::size_t k = 0; k < kCorners.size(); ++k) columns[kCorners[k]] = ArrayOf(pixels[k]);
  return columns;
}

// A new log, as fathom_track --out makes it.
void SaveTrack(const TrackedInPython& result, const py::object& path) {
  RequireUsable(result);
  const fs::path named = PathOf(path);
  const fs::path folder = named.has_filename() ? named : named.parent_path();
  if (Exists(folder)) {
    throw InputError(fmt::format("{}: is there already, expected a new folder.", folder.string()));
  }
  const py::gil_scoped_release release;
  const Temporary made(folder);
  CopyLog(result.input.log, result.track, made.path());
  WriteTrack(made.path(), result.track, result.summary.remarks);
  if (result.input.images) {
    WriteDetections(made.path() / "detections.csv", result.input.detections);
  }
  made.TakePlace();
}

std::string TrackText(const TrackedInPython& result) {
  const std::string failure =
      result.IsUsable() ? "" : "no usable trajectory: " + result.Message() + "\n";
  return failure + FormatText(result.summary, result.track) +
         NoteLines(TextsOf(result.summary.remarks));
}

}  // namespace

void BindTrack(py::module_& module) {
  py::class_<TrackedInPython>(module, "Track", "A vehicle's trajectory from markers.")
      .def_property_readonly("is_usable", &TrackedInPython::IsUsable)
      .def_property_readonly("message", &TrackedInPython::Message, "Why the track ended as it did.")
      .def_property_readonly("trajectory",
                             &BodyPath,
                             "The vehicle's Trajectory, world_from_body. Raises ValueError where "
                             "the track is not usable.")
      .def_property_readonly(
          "camera", &CameraPath, "The camera's Trajectory, world_from_camera (x right, z ahead).")
      .def_property_readonly("detections",
                             &DictOfDetections,
                             "The columns of detections.csv: distorted pixels, a row each.")
      .def_property_readonly(
          "corner_sigma",
          [](const TrackedInPython& result) { return result.track.corner_sigma; },
          "Standard deviation of a corner's u and v [px], from the residuals.")
      .def_property_readonly(
          "remarks",
          [](const TrackedInPython& result) {
            return InPythonWords(TextsOf(result.summary.remarks));
          },
          "What was lost and what was decided, a sentence each.")
      .def("save", &SaveTrack, py::arg("path"), "Writes a new log, as fathom_track --out.")
      .def(
          "to_dict",
          [](const TrackedInPython& result) {
            return DictOfJson(FormatJson(result.summary, result.track, result.input.detections));
          },
          "What fathom_track --summary writes: schema fathom-track-1.")
      .def("__repr__", &TrackText)
      .def("_repr_html_",
           [](const TrackedInPython& result) { return NotebookText(TrackText(result)); });

  module.def(
      "track",
      &TrackInPython,
      py::arg("log"),
      py::kw_only(),
      py::arg("from_") = py::none(),
      py::arg("estimate_markers") = false,
      py::arg("reference") = py::none(),
      py::arg("gate") = 4.0,
      py::arg("max_hamming") = py::none(),
      py::arg("quad_decimate") = py::none(),
      py::arg("quad_sigma") = py::none(),
      py::arg("threads") = py::none(),
      "The trajectory of a vehicle from the markers that its camera sees: docs/vision.md, "
      "docs/marker_trajectory.md.\n\n"
      "log               the path of a log folder with images, a video or detections.csv, "
      "or a Log opened from one\n"
      "from_             \"images\" or \"detections\"; default: detections if there are any\n"
      "estimate_markers  estimate the places of all markers but one\n"
      "reference         the id of the marker that then stays; default: the one seen most\n"
      "gate              detections with larger errors, in corner sigmas, are outliers\n"
      "max_hamming       bits of a tag's code that may be wrong: 0 (default), 1 or 2\n"
      "quad_decimate     look for tags in images smaller by this factor. Default 1\n"
      "quad_sigma        blur images by this before [px]. Default 0\n"
      "threads           of the detection. Default 1\n\n"
      "A Track. Writes nothing; Track.save() writes a new log.");
}

}  // namespace fathom
