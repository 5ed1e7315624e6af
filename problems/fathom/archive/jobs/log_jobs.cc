// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/log_jobs.h"

#include "fathom/base/exit_code.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/base/shell_word.h"
#include "fathom/log/log_content.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

namespace fs = std::filesystem;

LogState StateOf(const RunRecord& run) {
  switch (run.end) {
    case ChildEnd::kSignalled:
      return LogState::kCrashed;
    case ChildEnd::kTimedOut:
      return LogState::kTimedOut;
    case ChildEnd::kOutOfMemory:
      return LogState::kOutOfMemory;
    case ChildEnd::kNotStarted:
      return LogState::kRefused;
    case ChildEnd::kExited:
      break;
  }
  switch (run.exit_code) {
    case kExitUsable:
      return LogState::kOk;
    case kExitNoFit:
      return LogState::kNoModel;
    case kExitOutOfMemory:
      return LogState::kOutOfMemory;
    default:
      return LogState::kRefused;
  }
}

// What the rows of a comparison say of why none of them is usable.
std::string MessageInRows(const std::string& comparison) {
  const auto json = nlohmann::json::parse(comparison, nullptr, false);
  if (!json.is_object() || !json.contains("rows")) return "";
  std::vector<std::string> messages;
  for (const auto& row : json["rows"]) {
    const std::string message = row.value("message", "");
    if (!message.empty() && std::ranges::count(messages, message) == 0) messages.push_back(message);
  }
  return fmt::format("{}", fmt::join(messages, " "));
}

std::string WhyNoModel(const RunRecord& compare) {
  const std::string in_rows = compare.end == ChildEnd::kExited && compare.exit_code == kExitNoFit
                                  ? MessageInRows(compare.output)
                                  : "";
  return in_rows.empty() ? WhyNot(compare) : in_rows;
}

// The worst of the states of single runs, where none is usable.
LogState Worst(const std::vector<LogState>& states) {
  for (const LogState state :
       {LogState::kCrashed, LogState::kOutOfMemory, LogState::kTimedOut, LogState::kRefused}) {
    if (std::ranges::count(states, state) > 0) return state;
  }
  return LogState::kNoModel;
}

void Add(const RunRecord& run, LogOutcome* outcome) {
  outcome->seconds += run.seconds;
  outcome->peak_mb = std::max(outcome->peak_mb, run.peak_mb);
}

// Ends the outcome with a run that did not work.
void Fail(const RunRecord& run, LogOutcome* outcome) {
  outcome->state = StateOf(run);
  outcome->message = WhyNot(run);
}

// The survey of the log at outcome->place; nothing if it failed, which the outcome then says.
std::optional<Survey> RunSurvey(const LogJobOptions& options,
                                const ProgramSettings& settings,
                                const RunBook& book,
                                LogOutcome* outcome) {
  ProgramCall call = {.program = "fathom_batch",
                      .contents = {outcome->place_content},
                      .places = {"--survey=" + outcome->place.string()}};
  std::error_code error;
  if (options.dof && !fs::is_directory(outcome->place, error)) {
    call.flags.push_back(fmt::format("--dof={}", Name(*options.dof)));
  }
  const RunRecord run = RunProgram(call, settings, book);
  Add(run, outcome);
  if (IsUsable(run)) {
    try {
      return ParseSurvey(run.output);
    } catch (const InputError& problem) {
      outcome->message = problem.what();
      outcome->state = LogState::kRefused;
      return std::nullopt;
    }
  }
  Fail(run, outcome);
  return std::nullopt;
}

fs::path PlaceOfMade(const LogJobOptions& options, const LogOutcome& outcome) {
  return options.made / outcome.content;
}

// Lets a program make the log, whose place the outcome then is; false if that failed, which the
// outcome then says.
bool MakeLog(ProgramCall call,
             const LogJobOptions& options,
             const ProgramSettings& settings,
             const RunBook& book,
             LogOutcome* outcome) {
  const fs::path made = PlaceOfMade(options, *outcome);
  std::error_code error;
  const RunBook only_if_there = {.find =
                                     [&](const std::string& key) {
                                       return fs::is_directory(made, error) ? book.find(key)
                                                                            : std::nullopt;
                                     },
                                 .keep = book.keep};
  call.places.push_back("--out=" + made.string());
  call.places.push_back("--overwrite");
  const RunRecord run = RunProgram(call, settings, only_if_there);
  Add(run, outcome);
  if (!IsUsable(run)) {
    Fail(run, outcome);
    return false;
  }
  TakeMadeLog(call.program, options, outcome);
  return true;
}

// Makes a log of the images.
bool Track(const LogJobOptions& options,
           const ProgramSettings& settings,
           const RunBook& book,
           LogOutcome* outcome) {
  return MakeLog({.program = "fathom_track",
                  .contents = {outcome->content},
                  .places = {"--log=" + outcome->place.string()},
                  .takes_vehicle = false,
                  .output = "summary"},
                 options,
                 settings,
                 book,
                 outcome);
}

// What says that a recording can be imported without a map; false if it cannot, or if that could
// not be found out, which the outcome then says.
bool NeedsNoMap(const FoundLog& log,
                const std::vector<std::string>& places,
                const ProgramSettings& settings,
                const RunBook& book,
                LogOutcome* outcome) {
  const RunRecord run = RunProgram({.program = "fathom_import",
                                    .contents = {outcome->content},
                                    .flags = {"--suggest"},
                                    .places = places,
                                    .takes_vehicle = false,
                                    .output = "json"},
                                   settings,
                                   book);
  Add(run, outcome);
  const bool knows_none = run.end == ChildEnd::kExited && run.exit_code == kExitNoFit;
  if (!IsUsable(run) && !knows_none) {
    Fail(run, outcome);
    return false;
  }
  const auto suggestion = nlohmann::json::parse(run.output, nullptr, false);
  if (suggestion.is_object() && suggestion.value("ready", false)) return true;
  outcome->state = LogState::kNoMap;
  outcome->message =
      suggestion.is_object() && suggestion.value("needs_vehicle", false)
          ? "needs a vehicle file whose thrusters its outputs drive: `vehicle` in archive.yaml."
          : fmt::format(
                "needs a map, which `imports` in archive.yaml names: fathom_import --suggest "
                "prints one to begin with (--from={}).",
                ShellWord(PathText(log.path)));
  return false;
}

// Makes a log of a recording.
bool Import(const FoundLog& log,
            const LogJobOptions& options,
            const ProgramSettings& settings,
            const RunBook& book,
            LogOutcome* outcome) {
  std::vector<std::string> places = {"--from=" + log.place};
  if (!log.vehicle.empty()) places.push_back("--vehicle=" + log.vehicle);
  if (log.map.empty() && !NeedsNoMap(log, places, settings, book, outcome)) return false;
  if (!log.map.empty()) places.push_back("--map=" + log.map);
  return MakeLog({.program = "fathom_import",
                  .contents = {outcome->content},
                  .places = std::move(places),
                  .takes_vehicle = false},
                 options,
                 settings,
                 book,
                 outcome);
}

// The diagnosis of one DOF, or of several together; with its page where pages are asked for.
RunRecord RunDiagnosis(const std::string& dofs,
                       const std::string& dof_flag,
                       const LogJobOptions& options,
                       const ProgramSettings& settings,
                       const RunBook& book,
                       LogOutcome* outcome) {
  ProgramCall call = {.program = "fathom_diagnose",
                      .contents = {outcome->place_content},
                      .flags = {dof_flag},
                      // The batch itself fills the cores.
                      .places = {"--log=" + outcome->place.string(), "--threads=1"},
                      .output = "verdict"};
  RunBook book_of_page = book;
  if (!options.pages.empty()) {
    const fs::path page = options.pages / PageNameOf(outcome->path, dofs);
    call.places.push_back("--report=" + page.string());
    book_of_page.find = [&book, page](const std::string& key) -> std::optional<RunRecord> {
      auto known = book.find(key);
      std::error_code error;
      const bool lacks_page = known && IsUsable(*known) && !fs::exists(page, error);
      return lacks_page ? std::nullopt : known;
    };
  }
  RunRecord run = RunProgram(call, settings, book_of_page);
  Add(run, outcome);
  return run;
}

DofRuns RunOnDof(Dof dof,
                 const LogJobOptions& options,
                 const ProgramSettings& settings,
                 const RunBook& book,
                 LogOutcome* outcome) {
  DofRuns runs;
  runs.dof = dof;
  ProgramCall compare = {.program = "fathom_compare",
                         .contents = {outcome->place_content},
                         .flags = {fmt::format("--dofs={}", Name(dof))},
                         .places = {"--log=" + outcome->place.string()},
                         .output = "json"};
  if (!options.families.empty()) compare.flags.push_back("--families=" + options.families);
  if (!options.weighting.empty()) compare.flags.push_back("--weighting=" + options.weighting);
  runs.compare = RunProgram(compare, settings, book);
  Add(runs.compare, outcome);
  if (!options.diagnose) return runs;
  runs.diagnose = RunDiagnosis(
      std::string(Name(dof)), fmt::format("--dof={}", Name(dof)), options, settings, book, outcome);
  return runs;
}

// Those that a log moves, whether or not their command changes.
std::vector<Dof> MovedDofs(const Survey& survey) {
  std::vector<Dof> dofs;
  for (const SurveyedDof& dof : survey.dofs) {
    if (dof.why_not.empty() || dof.may_help) dofs.push_back(dof.dof);
  }
  std::ranges::sort(dofs);
  return dofs;
}

// Nothing of a log that moves one DOF: its own diagnosis tells all of it.
std::optional<CoupledRun> RunCoupled(const LogJobOptions& options,
                                     const ProgramSettings& settings,
                                     const RunBook& book,
                                     LogOutcome* outcome) {
  if (!options.coupled_dofs) return std::nullopt;
  const std::vector<Dof> dofs =
      options.coupled_dofs->empty() ? MovedDofs(*outcome->survey) : *options.coupled_dofs;
  if (dofs.size() < 2) return std::nullopt;
  CoupledRun run = {.dofs = JoinedNames(dofs), .diagnose = {}, .left_out = {}};
  if (options.coupled_dofs->empty()) run.left_out = outcome->survey->undriven;
  run.diagnose = RunDiagnosis(run.dofs, "--dofs=" + run.dofs, options, settings, book, outcome);
  return run;
}

void Judge(LogOutcome* outcome) {
  std::vector<LogState> failures;
  std::vector<std::string> messages;
  std::size_t num_usable = 0;
  const auto judge = [&](std::string_view dofs, const RunRecord& run, const std::string& why_not) {
    if (IsUsable(run)) {
      ++num_usable;
      return;
    }
    failures.push_back(StateOf(run));
    messages.push_back(fmt::format("{}, {}: {}", dofs, run.program, why_not));
  };
  for (const DofRuns& runs : outcome->dofs) {
    judge(Name(runs.dof), runs.compare, WhyNoModel(runs.compare));
    if (runs.diagnose) judge(Name(runs.dof), *runs.diagnose, WhyNot(*runs.diagnose));
  }
  if (const auto& coupled = outcome->coupled) {
    judge(coupled->dofs, coupled->diagnose, WhyNot(coupled->diagnose));
  }
  outcome->message = fmt::format("{}", fmt::join(messages, " "));
  if (failures.empty()) {
    outcome->state = LogState::kOk;
  } else {
    outcome->state = num_usable > 0 ? LogState::kPartial : Worst(failures);
  }
}

// With '_' for what may not stand in the name of a file.
std::string FileWord(std::string_view text) {
  std::string word;
  for (const char c : text) {
    word += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '.' ? c : '_';
  }
  return word;
}

// Of the DOFs that the log cannot identify.
std::string WhyNothing(const Survey& survey) {
  if (survey.dofs.empty()) return "no command.";
  std::vector<std::string> reasons;
  for (const SurveyedDof& dof : survey.dofs) {
    if (dof.why_not.empty()) continue;
    reasons.push_back(fmt::format("{}: {}", Name(dof.dof), dof.why_not));
  }
  return fmt::format("{}", fmt::join(reasons, " "));
}

}  // namespace

std::string JoinedNames(const std::vector<Dof>& dofs) {
  std::vector<std::string_view> names;
  for (const Dof dof : dofs) names.push_back(Name(dof));
  return fmt::format("{}", fmt::join(names, ","));
}

std::string PageNameOf(const std::string& path, std::string_view dofs) {
  constexpr std::size_t kLongest = 100;
  return fmt::format("{}_{}_{}.html",
                     FileWord(path).substr(0, kLongest),
                     FileWord(dofs),
                     DigestOf(path).substr(0, 8));
}

LogOutcome OutcomeOfFound(const FoundLog& log, const std::string& content) {
  LogOutcome outcome;
  outcome.place = log.place;
  outcome.path = PathText(log.path);
  outcome.content = content;
  outcome.place_content = content;
  return outcome;
}

void TakeMadeLog(const std::string& program, const LogJobOptions& options, LogOutcome* outcome) {
  outcome->place = PlaceOfMade(options, *outcome);
  outcome->place_content = DigestOf({outcome->content, program});
  outcome->made_by = program;
}

LogOutcome PrepareLog(const FoundLog& log,
                      const std::string& content,
                      const LogJobOptions& options,
                      const ProgramSettings& settings,
                      const RunBook& book) {
  LogOutcome outcome = OutcomeOfFound(log, content);
  if (log.is_recording && !Import(log, options, settings, book, &outcome)) return outcome;
  outcome.survey = RunSurvey(options, settings, book, &outcome);
  if (outcome.survey && outcome.survey->needs_tracking) {
    if (!Track(options, settings, book, &outcome)) return outcome;
    const Survey of_images = *outcome.survey;
    outcome.survey = RunSurvey(options, settings, book, &outcome);
    if (outcome.survey && std::isnan(outcome.survey->start)) {
      outcome.survey->start = of_images.start;
    }
  }
  return outcome;
}

LogOutcome RunPrograms(LogOutcome outcome,
                       const LogJobOptions& options,
                       const ProgramSettings& settings,
                       const RunBook& book) {
  for (const SurveyedDof& dof : outcome.survey->dofs) {
    if (!dof.why_not.empty()) continue;
    outcome.dofs.push_back(RunOnDof(dof.dof, options, settings, book, &outcome));
  }
  if (outcome.dofs.empty()) {
    outcome.state = LogState::kNothingToIdentify;
    outcome.message = WhyNothing(*outcome.survey);
    return outcome;
  }
  outcome.coupled = RunCoupled(options, settings, book, &outcome);
  Judge(&outcome);
  const std::string nothing = WhyNothing(*outcome.survey);
  if (!nothing.empty()) {
    outcome.message +=
        (outcome.message.empty() ? "Not identified: " : " Not identified: ") + nothing;
  }
  return outcome;
}

}  // namespace fathom
