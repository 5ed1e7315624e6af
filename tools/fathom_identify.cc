// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// One DOF's model from one log, or from several together, by one identifier family.

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/comparison/comparison.h"
#include "fathom/comparison/identification_text.h"
#include "fathom/comparison/joint_identification.h"
#include "fathom/signal/log_column.h"
#include "fathom/tool/identifier_flags.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/tool.h"
#include "fathom/vehicle/model_file.h"

#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(dof, "", "surge, sway, heave, roll, pitch or yaw; the log's only one if not given.");
DEFINE_string(family,
              "output_error",
              "least_squares, adaptive, output_error or joint (of the source camera).");
DEFINE_string(source, "", "pose_estimator or camera; the best the log has if not given.");
DEFINE_string(model, "", "Write the model to this JSON file.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_identify",
    "Identifies the motion model of one degree of freedom from logs.",
    "--log=LOG[,LOG...] --dof=DOF [--family=FAMILY] [--source=SOURCE] [--velocity=FILE] "
    "[--model=FILE]",
    "fathom_identify --log=data/flatfish --dof=surge --model=surge.json",
    "Several logs are fitted together, each with an initial state of its own. The family joint "
    "takes "
    "the corners in detections.csv and the camera's calibration: docs/joint_refinement.md."};

Dof DofFromFlagOrLog(const Log& log) {
  if (!FLAGS_dof.empty()) return ParseFlag("dof", FLAGS_dof, ParseDof);
  if (log.dofs.size() == 1) return log.dofs.front();
  throw InputError(
      fmt::format("--dof: is missing, and the log names {} DOFs; say which.", log.dofs.size()));
}

Source SourceFromFlagOrLog(const Log& log, Dof dof, Family family) {
  if (!FLAGS_source.empty()) return ParseFlag("source", FLAGS_source, ParseSource);
  if (family == Family::kJoint) return Source::kCamera;
  const auto sources = SourcesOf(log, dof);
  return sources.empty() ? Source::kPoseEstimator : sources.front();
}

std::vector<Log> LogsFromFlags(Family family) {
  std::optional<Dof> given;
  if (!FLAGS_dof.empty()) given = ParseFlag("dof", FLAGS_dof, ParseDof);
  if (!FLAGS_velocity.empty() && FLAGS_log.find(',') != std::string::npos) {
    throw InputError("--velocity: belongs to one log, expected a single --log with it.");
  }
  std::vector<Log> logs;
  for (const std::string& path : LogPathsFromFlags()) {
    logs.push_back(ReadLogFromFlags(path, given));
    if (FLAGS_source == Name(Source::kCamera) || family == Family::kJoint) {
      AddCameraSource(&logs.back());
    }
  }
  RequireDifferentData(logs);
  return logs;
}

// The signals of all logs as one, a segment each or more.
Signals SignalsOfAll(const std::vector<Log>& logs, Family family) {
  Signals all;
  for (const Log& log : logs) {
    const Dof dof = DofFromFlagOrLog(log);
    Signals signals = SignalsOf(log, dof, {.source = SourceFromFlagOrLog(log, dof, family)});
    if (&log == &logs.front()) {
      all = std::move(signals);
      continue;
    }
    if (signals.dof != all.dof) {
      throw InputError(
          fmt::format("{}: its DOF is {}, expected {} as in the first log; say which with --dof.",
                      log.path.string(),
                      Name(signals.dof),
                      Name(all.dof)));
    }
    if (signals.force_unit != all.force_unit || signals.source != all.source) {
      throw InputError(fmt::format(
          "{}: its command unit or source differs from the first log's ({} from {}, expected {} "
          "from {}).",
          log.path.string(),
          signals.force_unit,
          Name(signals.source),
          all.force_unit,
          Name(all.source)));
    }
    Append(signals, &all);
  }
  return all;
}

int Run() {
  RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
  const Family family = ParseFlag("family", FLAGS_family, ParseFamily);
  const IdentificationOptions options = IdentificationOptionsFromFlags();
  if (family == Family::kJoint && FLAGS_source == Name(Source::kPoseEstimator)) {
    throw InputError(
        "--source: is 'pose_estimator', expected camera: the family joint takes the corners that "
        "a camera saw.");
  }
  RequireOutputs({{"model", FLAGS_model}}, InputsFromFlags());
  std::vector<Log> logs = LogsFromFlags(family);
  const Signals signals = SignalsOfAll(logs, family);
  if (IsAllHeldOut(signals)) {
    throw InputError(fmt::format("{}: {}", FileOf(logs.front(), "log.yaml"), kAllIsHeldOut));
  }
  std::vector<std::string> remarks;
  Identification result = family == Family::kJoint
                              ? IdentifyJointly(std::move(logs), signals, options.joint, &remarks)
                              : Identify(signals, signals, family, options);
  for (const std::string& remark : signals.remarks) std::printf("note: %s\n", remark.c_str());
  for (const Finding& finding : CheckSanity(signals)) {
    std::printf("%s: %s\n",
                finding.severity == Severity::kWarning ? "WARNING" : "note",
                finding.sentence.c_str());
  }
  for (const std::string& remark : remarks) std::printf("note: %s\n", remark.c_str());
  std::printf("%s", FormatIdentification(result).c_str());
  if (!result.is_usable) {
    std::fprintf(stderr, "fathom_identify: no usable model: %s\n", result.message.c_str());
    return 2;
  }
  if (!FLAGS_model.empty()) {
    result.fitted.provenance = {{"log", FLAGS_log},
                                {"family", std::string(Name(family))},
                                {"source", std::string(Name(result.source))},
                                {"velocity", FLAGS_velocity},
                                {"gains", FLAGS_gains},
                                {"integrator", FLAGS_integrator},
                                {"huber", fmt::format("{}", FLAGS_huber)},
                                {"shooting_window", fmt::format("{}", FLAGS_shooting_window)},
                                {"version", FATHOM_VERSION}};
    WriteFile(FLAGS_model, FormatModel(result.fitted));
  }
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
