// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The model of one DOF, or of several coupled ones, from one log or from several together.

#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/coupled/coupled_text.h"
#include "fathom/findings/log_check.h"
#include "fathom/free_decay/decay_text.h"
#include "fathom/free_decay/log_decay.h"
#include "fathom/identification/identification_text.h"
#include "fathom/identification/log_identification.h"
#include "fathom/identification/run_agreement_text.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/signal/sources/dof_of_log.h"
#include "fathom/tool/coupled_flags.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/identifier_flags.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/structure_flag.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/wide_flag.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(family,
              "output_error",
              "least_squares, adaptive, output_error or joint (needs the source camera).");
DEFINE_string(source,
              "",
              "pose_estimator (velocity.csv) or camera (poses). Default: velocity.csv, "
              "or the poses if the log has no velocities.");
DEFINE_string(
    offset,
    "shared",
    "Output error of several logs: shared (one buoyancy in all) or per_log (each its own; "
    "inertia and damping are shared).");
DEFINE_string(model, "", "Write the model to this JSON file.");
DEFINE_double(decay_from,
              std::numeric_limits<double>::quiet_NaN(),
              "Take the log for a free decay from this time on [s], where nothing drives the "
              "vehicle: with a command only where that is 0. A log without a command is one "
              "anyway.");
DEFINE_string(json, "", "Of a free decay: write what it tells to this JSON file.");

DECLARE_string(correct);
DECLARE_string(held_out);

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_identify",
    "Identifies the motion model of one degree of freedom, or of several together, from logs.",
    "--log=LOG [--log=LOG ...] --dof=DOF [--family=FAMILY] [--source=SOURCE] [--velocity=FILE] "
    "[--offset=shared|per_log] [--model=FILE] [--decay_from=SECONDS] [--json=FILE]\n"
    "--log=LOG [--log=LOG ...] --dofs=DOF,DOF... [--structure=STRUCTURE] [--free=ENTRY,...] "
    "[--window=SECONDS] [--model=FILE]",
    "fathom_identify --log=data/flatfish --dof=surge --model=surge.json",
    "Several logs, as --log=A --log=B or --log=A,B, are fitted together, each with its own initial "
    "state, and with --offset=per_log its own buoyancy. The family joint uses "
    "the corners in detections.csv and the camera's calibration: docs/joint_refinement.md. A log "
    "without a command is a free decay, which tells damping by inertia: docs/free_decay.md. "
    "--dofs makes one model of several degrees of freedom: docs/coupled.md.",
    {"log"}};

LogIdentificationOptions OptionsFromFlags() {
  LogIdentificationOptions options;
  options.family = ParseFlag("family", FLAGS_family, ParseFamily);
  options.identification = IdentificationOptionsFromFlags();
  options.offset = ParseFlag("offset", FLAGS_offset, ParseOffsetScope);
  options.dof = DofFromFlag();
  if (!FLAGS_source.empty()) options.source = ParseFlag("source", FLAGS_source, ParseSource);
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("--{}.", problems.front()));
  }
  return options;
}

std::vector<Log> LogsFromFlags(const LogIdentificationOptions& options) {
  std::vector<Log> logs = ReadLogsFromFlags(options.dof, false, true);
  RequireDofOrDofs(logs, options.dof);
  if (options.source == Source::kCamera || options.family == Family::kJoint) {
    for (Log& log : logs) AddCameraSource(&log);
  }
  return logs;
}

// The files that the velocities of --log come from.
std::string VelocityFiles() {
  namespace fs = std::filesystem;
  if (!FLAGS_velocity.empty()) return fs::path(FLAGS_velocity).filename().string();
  std::set<std::string> files;
  for (const std::string& log : LogPathsFromFlags()) {
    const fs::path path(log);
    files.insert(fs::is_directory(path) ? "velocity.csv" : path.filename().string());
  }
  return fmt::format("{}", fmt::join(files, ", "));
}

void Print(const LogIdentification& identified) {
  PrintWarnings(identified.findings);
  for (const std::string& remark : identified.signals.remarks) {
    PrintText(stdout, "note: " + remark + "\n");
  }
  PrintNotes(identified.findings);
  for (const std::string& remark : identified.remarks) PrintText(stdout, "note: " + remark + "\n");
  PrintText(stdout, FormatIdentification(identified.result, VelocityFiles()));
  const FittedModel& fitted = identified.result.fitted;
  if (!identified.offsets.empty()) {
    const Table offsets = OffsetTable(identified.offsets, fitted.dof, fitted.force_unit);
    std::printf("\n%s", TableForTerminal(offsets).c_str());
  }
  if (!identified.agreement) return;
  const Table runs = RunTable(*identified.agreement, fitted.dof, fitted.force_unit);
  std::printf("\n%s", TableForTerminal(runs).c_str());
}

std::map<std::string, std::string> ProvenanceOf(const Identification& result) {
  std::map<std::string, std::string> provenance = {
      {"log", fmt::format("{}", fmt::join(LogPathsFromFlags(), ","))},
      {"family", std::string(Name(result.family))},
      {"source", std::string(Name(result.source))},
      {"velocity", FLAGS_velocity},
      {"held_out", FLAGS_held_out},
      {"gains", result.gains ? FormatGains(*result.gains) : FLAGS_gains},
      {"integrator", FLAGS_integrator},
      {"offset", FLAGS_offset},
      {"huber", fmt::format("{}", FLAGS_huber)},
      {"shooting_window", fmt::format("{}", FLAGS_shooting_window)},
      {"version", FATHOM_VERSION}};
  if (!FLAGS_correct.empty()) provenance["correct"] = FLAGS_correct;
  if (!result.weighting.empty()) {
    provenance["weighting"] = result.weighting;
    provenance["weighting_reason"] = result.weighting_reason;
  }
  return provenance;
}

bool HasDecayFrom() { return !std::isnan(FLAGS_decay_from); }

// Whether the logs are to be taken for free decays. Throws InputError as AreFreeDecays() does.
bool ToBeTakenForDecays(const std::vector<Log>& logs, const LogIdentificationOptions& options) {
  if (HasDecayFrom()) return true;
  const auto lacks_command = [](const Log& log) { return !log.command.has_value(); };
  const auto without = std::ranges::find_if(logs, lacks_command);
  if (without == logs.end()) {
    if (options.family != Family::kOutputError) return false;
    // The identification says that --dof is missing.
    if (!options.dof && logs.front().dofs.size() != 1) return false;
  }
  return AreFreeDecays(logs, DofOfAll(logs, options.dof));
}

void RefuseFlagsOfDrivenLogs(const LogIdentificationOptions& options) {
  if (options.family != Family::kOutputError) {
    throw InputError(fmt::format(
        "--family: is {}, which needs a command; expected none, or output_error: nothing drives "
        "this log. Record what was commanded, or leave --family out for a free decay.",
        Name(options.family)));
  }
  if (options.offset != OffsetScope::kShared) {
    throw InputError("--offset: is per_log, expected none: a free decay has one constant force.");
  }
}

std::map<std::string, std::string> DecayProvenance(const LogDecay& decay) {
  std::map<std::string, std::string> provenance = {
      {"log", fmt::format("{}", fmt::join(LogPathsFromFlags(), ","))},
      {"family", "free_decay"},
      {"source", std::string(Name(decay.source))},
      {"velocity", FLAGS_velocity},
      {"held_out", FLAGS_held_out},
      {"version", FATHOM_VERSION}};
  if (!FLAGS_correct.empty()) provenance["correct"] = FLAGS_correct;
  if (HasDecayFrom()) provenance["decay_from"] = fmt::format("{}", FLAGS_decay_from);
  return provenance;
}

int RunFreeDecay(const std::vector<Log>& logs, const LogIdentificationOptions& options) {
  RefuseFlagsOfDrivenLogs(options);
  LogDecayOptions decay_options;
  decay_options.dof = options.dof;
  decay_options.source = options.source;
  if (HasDecayFrom()) decay_options.from = FLAGS_decay_from;
  const LogDecay decay = FitLogDecay(logs, decay_options);
  const std::vector<Finding> findings = FindingsOn(logs, decay);
  PrintWarnings(findings);
  PrintNotes(findings);
  PrintText(stdout, FormatDecay(decay));
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, FormatDecayJson(decay, FLAGS_log));
  if (!decay.summary.IsUsable()) {
    PrintText(stderr, "fathom_identify: no usable model: " + decay.summary.message + "\n");
    return kExitNoFit;
  }
  if (FLAGS_model.empty()) return kExitUsable;
  std::optional<FittedModel> model = ModelOf(decay);
  if (!model) {
    throw InputError(fmt::format(
        "--model: a model needs {}. --json writes what this decay tells.",
        decay.has_stiffness
            ? "a DOF that nothing pulls back: a model file holds no stiffness"
            : fmt::format("the inertia, expected `inertia: {{{}: ...}}` in the vehicle file",
                          Name(decay.dof))));
  }
  model->provenance = DecayProvenance(decay);
  model->log_fingerprints = FingerprintsOf(logs);
  WriteFile(FLAGS_model, FormatModel(*model));
  return kExitUsable;
}

int RunCoupledIdentification() {
  const CoupledIdentificationOptions options = StructuredOptionsFromFlags();
  RequireOutputs({{"model", FLAGS_model}}, InputsFromFlags());
  std::vector<Log> logs = ReadCoupledLogsFromFlags();
  // Before the fit, which takes a while.
  const std::vector<Finding> findings = CheckLogs(logs, options.dofs);
  PrintWarnings(findings);
  PrintNotes(findings);
  std::fflush(stdout);
  CoupledIdentification identified = IdentifyCoupled(std::move(logs), options);
  for (const std::string& remark : identified.remarks) PrintText(stdout, "note: " + remark + "\n");
  if (!identified.is_usable) {
    std::fprintf(stderr, "fathom_identify: no usable model: %s.\n", identified.message.c_str());
    return kExitNoFit;
  }
  PrintText(stdout, FormatCoupledIdentification(identified));
  if (FLAGS_model.empty()) return kExitUsable;
  identified.fitted.provenance = {{"log", fmt::format("{}", fmt::join(LogPathsFromFlags(), ","))},
                                  {"velocity", FLAGS_velocity},
                                  {"held_out", FLAGS_held_out},
                                  {"structure", FLAGS_structure},
                                  {"window", fmt::format("{}", FLAGS_window)},
                                  {"version", FATHOM_VERSION}};
  if (!FLAGS_correct.empty()) identified.fitted.provenance["correct"] = FLAGS_correct;
  if (!FLAGS_free.empty()) identified.fitted.provenance["free"] = FLAGS_free;
  WriteFile(FLAGS_model, FormatCoupledModel(identified.fitted));
  return kExitUsable;
}

int Run() {
  RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
  std::vector<const char*> of_one_dof = {"dof",
                                         "family",
                                         "source",
                                         "offset",
                                         "json",
                                         "gains",
                                         "integrator",
                                         "huber",
                                         "shooting_window",
                                         "weighting"};
  // gflags takes a NaN for given.
  if (HasDecayFrom()) of_one_dof.push_back("decay_from");
  RequireFlagsOfOneKind(of_one_dof);
  if (IsCoupledAsked()) return RunCoupledIdentification();
  const LogIdentificationOptions options = OptionsFromFlags();
  RequireOutputs({{"model", FLAGS_model}, {"json", FLAGS_json}}, InputsFromFlags());
  std::vector<Log> logs = LogsFromFlags(options);
  if (ToBeTakenForDecays(logs, options)) return RunFreeDecay(logs, options);
  if (!FLAGS_json.empty()) {
    throw InputError(
        "--json: goes with a free decay, expected none: a command drives this log. --model writes "
        "the model.");
  }
  std::vector<std::string> fingerprints = FingerprintsOf(logs);
  LogIdentification identified = IdentifyFromLogs(std::move(logs), options);
  Print(identified);
  Identification& result = identified.result;
  if (!result.is_usable) {
    std::fprintf(stderr, "fathom_identify: no usable model: %s\n", result.message.c_str());
    return 2;
  }
  if (!FLAGS_model.empty()) {
    result.fitted.provenance = ProvenanceOf(result);
    result.fitted.log_fingerprints = std::move(fingerprints);
    WriteFile(FLAGS_model, FormatModel(result.fitted));
  }
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
