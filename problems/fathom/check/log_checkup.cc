// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/log_checkup.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/base/shell_word.h"
#include "fathom/check/unusual_mass.h"
#include "fathom/findings/camera_delay.h"
#include "fathom/findings/command_check.h"
#include "fathom/findings/command_clock.h"
#include "fathom/findings/fin_check.h"
#include "fathom/findings/log_check.h"
#include "fathom/findings/motion_check.h"
#include "fathom/findings/pose_flips.h"
#include "fathom/findings/pose_jumps.h"
#include "fathom/findings/pose_twist_check.h"
#include "fathom/findings/stamp_check.h"
#include "fathom/free_decay/decay_text.h"
#include "fathom/free_decay/log_decay.h"
#include "fathom/identification/log_identification.h"
#include "fathom/open_log/open_log.h"
#include "fathom/open_log/survey.h"
#include "fathom/report/format_value.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/log_column.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

void Add(std::vector<Finding> more, std::vector<Finding>* findings) {
  std::ranges::move(more, std::back_inserter(*findings));
}

std::vector<StreamSummary> StreamsOf(const Log& log) {
  std::vector<StreamSummary> streams;
  const std::pair<const char*, const std::optional<Stream>*> files[] = {
      {"command.csv", &log.command},
      {"velocity.csv", &log.velocity},
      {"pose.csv", &log.pose},
      {"detections.csv", &log.detections}};
  for (const auto& [file, stream] : files) {
    if (!*stream || (*stream)->time.empty()) continue;
    const std::vector<double>& time = (*stream)->time;
    StreamSummary summary = {file, time.size(), time.front(), time.back(), 0.0, 0.0};
    // Detections have a row for each marker of a frame.
    std::vector<double> stamps = time;
    stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
    if (stamps.size() > 1) summary.rate = 1.0 / MedianStep(stamps);
    for (std::size_t i = 1; i < stamps.size(); ++i) {
      summary.longest_gap = std::max(summary.longest_gap, stamps[i] - stamps[i - 1]);
    }
    streams.push_back(std::move(summary));
  }
  return streams;
}

// What the checks say of a DOF that cannot be identified; nothing where they cannot run.
std::vector<Finding> FindingsWithoutFit(const Log& log, Dof dof) {
  try {
    return CheckLogs({&log, 1}, dof);
  } catch (const InputError&) {
    return {};  // why_not says it already
  }
}

std::string HowToAddMass(const Log& log) {
  if (!IsSingleCsv(log)) return fmt::format("Add `mass:` (dry, in kg) to {}.", PlaceOfKeys(log));
  return fmt::format(
      "A log folder tells it: fathom_import --from={0} --suggest > map.yaml, add `mass:` (dry, in "
      "kg) to map.yaml, then fathom_import --from={0} --map=map.yaml --out={1}.",
      ShellWord(log.path.string()),
      ShellWord(log.path.stem().string()));
}

// A vehicle file that is missing or has no mass has a remark of its own. A turn is held against no
// mass, nor is a command that is no force.
void AddRemarkOnUnknownMass(LogCheckup* checkup) {
  Log& log = checkup->log;
  const bool is_held_against_mass =
      log.command_unit.empty() &&
      std::ranges::any_of(checkup->dofs, [](const DofCheckup& dof) { return !IsAngular(dof.dof); });
  if (log.mass || log.vehicle.ends_with(".yaml") || !is_held_against_mass) return;
  log.remarks.push_back(
      {RemarkKind::kGeneral,
       fmt::format("No mass of the vehicle is known, so that the units of force and motion cannot "
                   "be checked. {}",
                   HowToAddMass(log))});
}

// The poses against velocity.csv. Those of a camera get the clock of velocity.csv first, so that a
// delay is told once and no axis for it.
std::vector<Finding> CheckTwoMotions(Log log) {
  if (!log.velocity) return {};
  if (!log.detections) return CheckPoseAgainstTwist(log);
  if (!log.pose) TrackDetectionsIfUsable(&log);
  std::vector<Finding> findings;
  if (const auto delay = FindCameraDelay(log)) {
    if (auto finding = CheckCameraClock(log, *delay)) findings.push_back(*std::move(finding));
    for (double& t : log.pose->time) t -= delay->delay;
  }
  Add(CheckPoseAgainstTwist(log), &findings);
  return findings;
}

Finding FindingOn(const PoorFit& fit) {
  return {Severity::kNote,
          "poor_fit",
          fmt::format("Simulated from the command alone, the model misses {:.0f} % of {}.",
                      100.0 * fit.nmae,
                      fit.motion)};
}

// A poor fit is told as a finding, and no second time as a caveat.
void Identify(const Log& log, DofCheckup* checkup) {
  LogIdentificationOptions options;
  options.dof = checkup->dof;
  options.source = BestSourceOf(log, checkup->dof);
  LogIdentification identified = IdentifyFromLogs({log}, options);
  checkup->findings = std::move(identified.findings);
  checkup->signals = std::move(identified.signals);
  checkup->command = CommandOf(log, checkup->dof);
  const auto& segments = checkup->signals->train;
  if (auto finding = CheckCommandClock(checkup->command, segments)) {
    checkup->findings.push_back(*std::move(finding));
  }
  Add(CheckCommand(checkup->command, segments, checkup->signals->force_unit), &checkup->findings);
  if (!identified.result.is_usable) {
    checkup->findings.push_back(
        {Severity::kNote,
         "no_model",
         fmt::format("There is no usable model: {}", identified.result.message)});
  }
  // A warning on the same inertia says more.
  auto heavy = CheckUsualMass(log, checkup->dof, identified.result);
  if (heavy && !Has(checkup->findings, "inertia")) checkup->findings.push_back(*std::move(heavy));
  if (const auto poor = PoorFitOf(identified.result.fitted)) {
    checkup->findings.push_back(FindingOn(*poor));
    std::erase(identified.result.fitted.caveats, CaveatOn(*poor));
  }
  checkup->excitation = ExcitationOf(checkup->command, segments);
  checkup->model = std::move(identified.result);
}

// What a log that nothing drives tells. It lacks no command then: that is no finding.
void LookAtDecay(const Log& log, const CheckUpOptions& options, DofCheckup* checkup) {
  const Dof dof = checkup->dof;
  if ((log.fins || log.shafts) && !log.command) return;  // they drive it
  LogDecay decay;
  try {
    decay = FitLogDecay({&log, 1}, {.dof = dof});
  } catch (const InputError& error) {
    checkup->why_not = error.what();
    return;
  }
  std::erase_if(checkup->findings,
                [](const Finding& finding) { return finding.code == "constant_command"; });
  if (!log.command) {
    const Source source = BestSourceOf(log, dof);
    Add(CheckStamps(log), &checkup->findings);
    Add(CheckMotion(log, dof, source), &checkup->findings);
  }
  const FreeDecaySummary& summary = decay.summary;
  if (!summary.IsUsable()) {
    checkup->why_not = fmt::format("no command, and no free decay: {}", summary.message);
    return;
  }
  checkup->why_not.clear();
  checkup->decays = true;
  checkup->findings.push_back(
      {Severity::kNote,
       decay.inertia ? "scaled_decay" : "free_decay",
       fmt::format(
           "{}, so that this is a free decay, from {}. It tells {}. "
           "fathom_identify {} --dof={}",
           log.command ? "The command is 0 throughout" : "There is no command",
           TimesOf(decay.stretches.front(), MotionStream(log, dof, decay.source).time.front()),
           QuantitiesText(decay),
           LogFlags(log, options),
           Name(dof))});
}

}  // namespace

bool IsSingleCsv(const Log& log) { return std::filesystem::is_regular_file(log.path); }

std::string PlaceOfKeys(const Log& log) {
  return log.origin ? "the map of the import" : "log.yaml";
}

std::string LogFlags(const Log& log, const CheckUpOptions& options) {
  return "--log=" + ShellWord(log.path.string()) + options.data_flags;
}

LogCheckup CheckUp(const std::filesystem::path& path, std::optional<Dof> dof) {
  return CheckUp(OpenLog(path, {.dof = dof, .may_lack_motion = true, .may_lack_command = true}),
                 {.dof = dof});
}

LogCheckup CheckUp(Log log, const CheckUpOptions& options) {
  if (!log.velocity && !log.pose && log.detections && log.command) TrackDetectionsIfUsable(&log);
  const Survey survey = SurveyOf(log);
  LogCheckup checkup;
  checkup.asked = options;
  checkup.streams = StreamsOf(log);
  checkup.findings = CheckTwoMotions(log);
  Add(CheckPoseJumps(log), &checkup.findings);
  Add(CheckFins(log), &checkup.findings);
  if (auto finding = CheckPoseFlips(log)) checkup.findings.push_back(*std::move(finding));
  // Where velocity.csv is the source, no DOF looks at the poses.
  if (log.velocity) {
    for (const Dof dof : {Dof::kSurge, Dof::kYaw}) {
      Add(CheckMotion(log, dof, Source::kCamera), &checkup.findings);
    }
  }
  checkup.findings = WarningsFirst(std::move(checkup.findings));
  if (survey.needs_tracking) {
    checkup.findings.push_back({Severity::kNote,
                                "not_tracked",
                                "The motion is in images alone: fathom_track comes first."});
  }
  for (const SurveyedDof& surveyed : survey.dofs) {
    if (options.dof && surveyed.dof != *options.dof) continue;
    const bool may_decay = IsFreeDecay(log, surveyed.dof) && !SourcesOf(log, surveyed.dof).empty();
    DofCheckup of_dof;
    of_dof.dof = surveyed.dof;
    of_dof.why_not = surveyed.why_not;
    if (of_dof.why_not.empty()) {
      Identify(log, &of_dof);
    } else {
      of_dof.findings = FindingsWithoutFit(log, of_dof.dof);
    }
    if (may_decay) LookAtDecay(log, options, &of_dof);
    of_dof.findings = WarningsFirst(std::move(of_dof.findings));
    checkup.dofs.push_back(std::move(of_dof));
  }
  checkup.log = std::move(log);
  AddRemarkOnUnknownMass(&checkup);
  return checkup;
}

std::vector<Finding> AllFindings(const LogCheckup& checkup) {
  std::vector<Finding> findings = checkup.findings;
  for (const DofCheckup& dof : checkup.dofs) Add(dof.findings, &findings);
  return findings;
}

bool HasRed(const LogCheckup& checkup) {
  return std::ranges::any_of(AllFindings(checkup), [](const Finding& finding) {
    return finding.severity == Severity::kWarning;
  });
}

}  // namespace fathom
