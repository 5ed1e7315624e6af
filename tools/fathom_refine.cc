// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Model and camera trajectory together, from the corners of markers.
//
//   fathom_refine --log=LOG --dof=DOF [--json=FILE --model=FILE --trajectory=FILE --report=FILE]
//   fathom_refine --log=LOG --dofs=DOF,DOF... [--structure=STRUCTURE --window=SECONDS --model=FILE
//                 --trajectory=FILE --report=FILE --true_poses=FILE]

#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/comparison/comparison_page.h"
#include "fathom/comparison/image_comparison.h"
#include "fathom/comparison/image_comparison_file.h"
#include "fathom/comparison/image_comparison_page.h"
#include "fathom/coupled_refinement/film_json.h"
#include "fathom/coupled_refinement/film_page.h"
#include "fathom/coupled_refinement/film_refinement.h"
#include "fathom/coupled_refinement/film_text.h"
#include "fathom/findings/log_check.h"
#include "fathom/geometry/stamped_pose.h"
#include "fathom/identification/identification_text.h"
#include "fathom/log/csv/csv_table.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/log/write_log.h"
#include "fathom/signal/sources/dof_of_log.h"
#include "fathom/tool/coupled_flags.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/identifier_flags.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/progress.h"
#include "fathom/tool/structure_flag.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/wide_flag.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/model_file.h"

#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(initial_guess,
              "",
              "Start from the model of this family: least_squares, adaptive or output_error. "
              "Default: output error on poses without flips.");
DEFINE_double(
    clock_offset_std,
    0.0,
    "Estimate the camera's clock offset, with this prior standard deviation [s]. 0: the clock is "
    "exact.");
DEFINE_double(size_scale_std,
              0.0,
              "Estimate the scale of the markers, with this prior standard deviation (0.03: 3 "
              "%). 0: the size is exact.");
DEFINE_double(mount_position_std,
              0.0,
              "Estimate the camera's position on the vehicle, with this prior standard deviation "
              "[m]. 0: the position is exact.");
DEFINE_double(mount_angle_std,
              0.0,
              "Estimate the camera's direction, with this prior standard deviation [rad]. 0: the "
              "direction is exact.");
DEFINE_string(json,
              "",
              "Write a row for each family, and the refinement, to this JSON file; of --dofs both "
              "models and their free runs.");
DEFINE_string(model, "", "Write the joint model to this JSON file.");
DEFINE_string(trajectory,
              "",
              "Write the refined poses with their standard deviations to this CSV file.");
DEFINE_string(report, "", "Write a page to this HTML file.");
DEFINE_string(true_poses,
              "",
              "Of --dofs: where the vehicle truly was, a CSV as pose.csv. Prints how far the poses "
              "are off it before and after.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    .name = "fathom_refine",
    .summary = "Estimates model and camera trajectory together from the corners of markers.",
    .usage =
        "--log=LOG --dof=DOF [--json=FILE] [--model=FILE] [--trajectory=FILE] [--report=FILE]\n"
        "--log=LOG --dofs=DOF,DOF... [--structure=STRUCTURE] [--free=ENTRIES] [--window=SECONDS] "
        "[--model=FILE] "
        "[--trajectory=FILE] [--report=FILE] [--true_poses=FILE]",
    .example =
        "fathom_synthesize --vehicle=data/vehicles/flatfish.yaml "
        "--experiment=data/experiments/film_heave.yaml --film=data/films/wall.yaml --out=heave\n"
        "  fathom_refine --log=heave --dof=heave --model=heave.json --report=heave.html\n"
        "  fathom_synthesize --vehicle=data/vehicles/planar_rov.yaml "
        "--experiment=data/experiments/film_planar.yaml --film=data/films/wall_four.yaml "
        "--out=plane\n"
        "  fathom_refine --log=plane --dofs=surge,sway,yaw --structure=symmetric "
        "--model=plane.json",
    .details =
        "Several --log are fitted together. A log needs detections.csv (from fathom_track), "
        "camera.yaml, tags.yaml, mount.yaml and command.csv. The table compares the families on "
        "the same images. Exit code 2: no family has a usable model, or there are no refined "
        "poses for --trajectory. See "
        "docs/joint_refinement.md. --dofs refines a model of several degrees of freedom: "
        "docs/coupled.md.",
    .repeatable_flags = {"log"}};

ImageComparisonOptions OptionsFromFlags() {
  ImageComparisonOptions options;
  options.identification = IdentificationOptionsFromFlags();
  if (!FLAGS_initial_guess.empty()) {
    options.initial_guess = ParseFlag("initial_guess", FLAGS_initial_guess, ParseSignalFamily);
  }
  JointOptions& joint = options.identification.joint;
  joint.clock_offset_std = FLAGS_clock_offset_std;
  joint.size_scale_std = FLAGS_size_scale_std;
  joint.mount_position_std = FLAGS_mount_position_std;
  joint.mount_angle_std = FLAGS_mount_angle_std;
  if (const auto problems = joint.Problems(); !problems.empty()) {
    throw InputError(fmt::format("--{}.", problems.front()));
  }
  return options;
}

void Print(const ImageComparison& images) {
  const DofComparison& dof = images.comparison.dofs.front();
  std::printf("%s\n", TableForTerminal(ParameterTable(dof)).c_str());
  std::printf("%s\n", TableForTerminal(IntervalTable(images)).c_str());
  if (images.joint.IsUsable())
    std::printf("%s\n", TableForTerminal(RefinementTable(images)).c_str());
  for (const std::string& remark : images.comparison.remarks) {
    PrintText(stdout, "note: " + remark + "\n");
  }
  for (const std::string& line : CommentsOn(dof)) PrintText(stdout, line + "\n");
}

void WriteFilmTrajectory(const FilmRefinement& refinement) {
  std::vector<StampedPose> poses;
  for (size_t w = 0; w < refinement.joint.windows.size(); ++w) {
    const RefinedWindow& window = refinement.joint.windows[w];
    for (size_t k = 0; k < window.world_from_body.size(); ++k) {
      poses.push_back({.time = refinement.film.windows[w].time[k],
                       .pose = window.world_from_body[k],
                       .covariance = window.pose_covariance[k]});
    }
  }
  WriteStream(FLAGS_trajectory, PoseStreamOf(poses));
}

void WriteTrajectory(const MarkerLogs& logs, const ImageComparison& images) {
  std::vector<StampedPose> poses;
  for (size_t r = 0; r < images.joint.segments.size(); ++r) {
    const RefinedSegment& segment = images.joint.segments[r];
    for (size_t k = 0; k < segment.world_from_body.size(); ++k) {
      poses.push_back({.time = logs.input.segments[r].time[k],
                       .pose = segment.world_from_body[k],
                       .covariance = segment.pose_covariance[k]});
    }
  }
  WriteStream(FLAGS_trajectory, PoseStreamOf(poses));
}

std::map<std::string, std::string> Provenance() {
  return {{"log", fmt::format("{}", fmt::join(LogPathsFromFlags(), ","))},
          {"family", std::string(Name(Family::kJoint))},
          {"source", std::string(Name(Source::kCamera))},
          {"initial_guess", FLAGS_initial_guess},
          {"clock_offset_std", fmt::format("{}", FLAGS_clock_offset_std)},
          {"size_scale_std", fmt::format("{}", FLAGS_size_scale_std)},
          {"mount_position_std", fmt::format("{}", FLAGS_mount_position_std)},
          {"mount_angle_std", fmt::format("{}", FLAGS_mount_angle_std)},
          {"version", FATHOM_VERSION}};
}

std::optional<Stream> TruePoses() {
  if (FLAGS_true_poses.empty()) return std::nullopt;
  const CsvSpec spec = {{"x", "y", "z", "qx", "qy", "qz", "qw"}, {}, ""};
  return ReadCsvTable(FLAGS_true_poses, spec).stream;
}

int RunCoupledRefinement() {
  FilmRefinementOptions options;
  options.identification = StructuredOptionsFromFlags();
  std::vector<std::string> inputs = InputsFromFlags();
  if (!FLAGS_true_poses.empty()) inputs.push_back(FLAGS_true_poses);
  RequireOutputs({{"json", FLAGS_json},
                  {"model", FLAGS_model},
                  {"trajectory", FLAGS_trajectory},
                  {"report", FLAGS_report}},
                 inputs);
  const std::optional<Stream> truth = TruePoses();
  std::vector<Log> logs = ReadCoupledLogsFromFlags(/*may_lack_motion=*/true);
  RequireTrainingData(logs);
  if ((!FLAGS_trajectory.empty() || truth) && logs.size() > 1) {
    throw InputError(
        fmt::format("--{}: holds the poses of one log, expected a single --log with it.",
                    truth ? "true_poses" : "trajectory"));
  }
  std::vector<std::string> fingerprints = FingerprintsOf(logs);
  const MarkerLogs markers = PrepareCoupledMarkerLogs(std::move(logs));
  const std::vector<Finding> findings = CheckLogs(markers.logs, options.identification.dofs);
  PrintWarnings(findings);
  PrintNotes(findings);
  std::fflush(stdout);
  std::optional<Progress> progress(std::in_place, "round");
  options.fit.on_round = [&](int round, int most) { progress->Show(round, most); };
  FilmRefinement refinement = RefineCoupled(markers, options);
  progress.reset();
  for (const std::string& remark : refinement.remarks) PrintText(stdout, "note: " + remark + "\n");
  if (!refinement.is_usable) {
    PrintText(stderr, "fathom_refine: no usable model: " + refinement.message + "\n");
    return kExitNoFit;
  }
  PrintText(stdout, FormatFilmRefinement(refinement));
  std::optional<PathErrors> path;
  if (truth) path = PathErrorsOf(refinement, *truth);
  if (path) PrintText(stdout, FormatPathErrors(*path));
  refinement.fitted.log_fingerprints = std::move(fingerprints);
  refinement.fitted.provenance = {{"log", fmt::format("{}", fmt::join(LogPathsFromFlags(), ","))},
                                  {"family", std::string(Name(Family::kJoint))},
                                  {"source", std::string(Name(Source::kCamera))},
                                  {"structure", FLAGS_structure},
                                  {"window", fmt::format("{}", FLAGS_window)},
                                  {"version", FATHOM_VERSION}};
  if (!FLAGS_free.empty()) refinement.fitted.provenance["free"] = FLAGS_free;
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatFilmRefinementJson(refinement, path));
  if (!FLAGS_model.empty()) WriteFile(FLAGS_model, FormatCoupledModel(refinement.fitted));
  if (!FLAGS_trajectory.empty()) WriteFilmTrajectory(refinement);
  if (!FLAGS_report.empty()) {
    Page page = FilmPage(refinement);
    page.origin = OriginOfPage(markers.logs);
    WriteFile(FLAGS_report, RenderPage(page));
  }
  return kExitUsable;
}

// Flags that only the refinement of one DOF heeds.
std::vector<const char*> FlagsOfOneDof() {
  return {"dof",
          "initial_guess",
          "clock_offset_std",
          "size_scale_std",
          "mount_position_std",
          "mount_angle_std",
          "gains",
          "integrator",
          "huber",
          "shooting_window",
          "weighting"};
}

int RunRefine() {
  RequireFlag("log", FLAGS_log, "a log folder with detections.csv");
  RequireFlagsOfOneKind(FlagsOfOneDof());
  if (IsCoupledAsked()) return RunCoupledRefinement();
  if (!FLAGS_true_poses.empty()) {
    throw InputError("--true_poses: goes with --dofs, expected none without it.");
  }
  ImageComparisonOptions options = OptionsFromFlags();
  RequireOutputs({{"json", FLAGS_json},
                  {"model", FLAGS_model},
                  {"trajectory", FLAGS_trajectory},
                  {"report", FLAGS_report}},
                 InputsFromFlags());
  const std::optional<Dof> given = DofFromFlag();
  // A log without poses is not tracked on the way in: PrepareMarkerLogs() does that.
  std::vector<Log> logs = ReadLogsFromFlags(given, /*may_lack_motion=*/true);
  RequireTrainingData(logs);
  if (!FLAGS_trajectory.empty() && logs.size() > 1) {
    throw InputError("--trajectory: holds the poses of one log, expected a single --log with it.");
  }
  RequireDofOrDofs(logs, given);
  const Dof dof = DofOfAll(logs, given);
  std::vector<std::string> fingerprints = FingerprintsOf(logs);
  const MarkerLogs markers = PrepareMarkerLogs(std::move(logs), dof);
  std::optional<Progress> progress(std::in_place, "round");
  options.identification.joint.on_round = [&](int round, int most) { progress->Show(round, most); };
  ImageComparison images = CompareOnImages(markers, options);
  progress.reset();

  Identification& row = images.comparison.dofs.front().rows.back();
  row.fitted.provenance = Provenance();
  row.fitted.log_fingerprints = std::move(fingerprints);
  PrintWarnings(images.comparison.dofs.front().findings);
  Print(images);
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatImageComparison(images));
  if (!FLAGS_report.empty()) {
    Page page = ImageComparisonPage(markers, images);
    page.origin = OriginOfPage(markers.logs);
    WriteFile(FLAGS_report, RenderPage(page));
  }
  if (!row.is_usable) {
    std::fprintf(stderr, "fathom_refine: no usable model: %s\n", row.message.c_str());
    return 2;
  }
  if (!FLAGS_model.empty()) WriteFile(FLAGS_model, FormatModel(row.fitted));
  if (FLAGS_trajectory.empty()) return 0;
  if (!images.joint.IsUsable()) {
    std::fprintf(stderr, "fathom_refine: no refined poses: %s\n", images.joint.message.c_str());
    return 2;
  }
  WriteTrajectory(markers, images);
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  return fathom::RunTool(argc, argv, fathom::kInfo, fathom::RunRefine);
}
