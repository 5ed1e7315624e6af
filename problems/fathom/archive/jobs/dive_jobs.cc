// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/dive_jobs.h"

#include "fathom/base/exit_code.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/log/log_content.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRefits = 20;  // in search of the log that spoils a fit

// A number of a JSON file, by its JSON pointer; NaN if it is not there.
double NumberIn(const std::string& text, const std::string& pointer) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  const nlohmann::json::json_pointer place(pointer);
  if (!json.is_object() || !json.contains(place) || !json[place].is_number()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return json[place].get<double>();
}

// Why what it wrote cannot be used; empty if it can, or the run says itself that it cannot. One
// damaged file must not end the batch.
std::string ProblemOfModel(const RunRecord& run) {
  if (!IsUsable(run)) return "";
  try {
    ParseModel("what it wrote", run.output);
    return "";
  } catch (const InputError& error) {
    return CleanText(error.what());
  }
}

RunRecord Identify(const DiveTask& task,
                   const std::vector<DiveLog>& logs,
                   const ProgramSettings& settings,
                   const RunBook& book) {
  ProgramCall call = {.program = "fathom_identify",
                      .flags = {fmt::format("--dof={}", Name(task.dof))},
                      .output = "model"};
  if (!task.weighting.empty()) call.flags.push_back("--weighting=" + task.weighting);
  for (const DiveLog& log : logs) {
    call.contents.push_back(log.content);
    call.places.push_back("--log=" + log.place);
  }
  RunRecord run = RunProgram(call, settings, book);
  if (const std::string problem = ProblemOfModel(run); !problem.empty()) {
    run.exit_code = kExitNoFit;
    run.message = problem;
  }
  return run;
}

std::vector<DiveLog> Without(std::vector<DiveLog> logs, std::size_t index) {
  logs.erase(logs.begin() + static_cast<std::ptrdiff_t>(index));
  return logs;
}

// Fits these logs of the dive together.
using JointFit = std::function<RunRecord(const std::vector<DiveLog>&)>;

bool IsRefused(const RunRecord& run) {
  return run.end == ChildEnd::kExited && run.exit_code == kExitBadInput;
}

// Takes the logs one by one, as long as the program takes them together.
void LeaveOutRefused(const JointFit& fit, DiveOutcome* outcome) {
  std::vector<DiveLog> kept;
  for (const DiveLog& log : outcome->logs) {
    kept.push_back(log);
    const RunRecord run = fit(kept);
    if (!IsRefused(run)) continue;
    outcome->left_out.push_back({log.path, WhyNot(run)});
    kept.pop_back();
  }
  outcome->logs = std::move(kept);
}

// The one log without which there is a usable fit, the best one.
void LeaveOutTheOneThatSpoils(const JointFit& fit, DiveOutcome* outcome) {
  std::optional<std::size_t> spoiler;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outcome->logs.size(); ++i) {
    const RunRecord run = fit(Without(outcome->logs, i));
    const double nmae = IsUsable(run) ? NumberIn(run.output, "/fit/nmae") : least;
    if (!(nmae < least)) continue;
    least = nmae;
    spoiler = i;
  }
  if (!spoiler) return;
  outcome->left_out.push_back(
      {outcome->logs[*spoiler].path, "with it the logs of the dive have no usable fit"});
  outcome->logs = Without(outcome->logs, *spoiler);
}

// NMAE of a model on each of the logs.
using Errors =
    std::function<std::vector<double>(const std::string& model, const std::vector<DiveLog>& logs)>;

double MeanOfKnown(const std::vector<double>& errors) {
  double sum = 0.0;
  int count = 0;
  for (const double error : errors) {
    if (!std::isfinite(error)) continue;
    sum += error;
    ++count;
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

// Whether the joint model is much worse than the logs' own models on at least half of those that
// have one.
bool IsSpoiled(const std::vector<DiveLog>& logs, const std::vector<double>& errors) {
  constexpr double kMostTimes = 1.5, kMostMore = 0.05;
  int num_known = 0, num_worse = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    if (!std::isfinite(logs[i].own_nmae)) continue;
    ++num_known;
    if (!(errors[i] <= kMostTimes * logs[i].own_nmae + kMostMore)) ++num_worse;
  }
  return num_worse > 0 && 2 * num_worse >= num_known;
}

// The log without which the joint model simulates the others best, if that is better by a third or
// more. False if there is none.
bool LeaveOutSpoiler(const JointFit& fit,
                     const Errors& errors_of,
                     const std::vector<double>& errors,
                     DiveOutcome* outcome) {
  constexpr double kLeastGain = 1.0 / 3.0;
  std::optional<std::size_t> spoiler;
  double least = std::numeric_limits<double>::infinity();
  double before = least;
  for (std::size_t i = 0; i < outcome->logs.size(); ++i) {
    const std::vector<DiveLog> others = Without(outcome->logs, i);
    const RunRecord run = fit(others);
    if (!IsUsable(run)) continue;
    const double mean = MeanOfKnown(errors_of(run.output, others));
    if (!(mean < least)) continue;
    least = mean;
    spoiler = i;
    std::vector<double> of_others = errors;
    of_others.erase(of_others.begin() + static_cast<std::ptrdiff_t>(i));
    before = MeanOfKnown(of_others);
  }
  if (!spoiler || !(least < (1.0 - kLeastGain) * before)) return false;
  outcome->left_out.push_back(
      {outcome->logs[*spoiler].path,
       fmt::format("with it the joint model simulates the other logs with an NMAE of {:.2f}, "
                   "without it with {:.2f}",
                   before,
                   least)});
  outcome->logs = Without(outcome->logs, *spoiler);
  return true;
}

// Those that the joint model does not describe though it describes the others, by the NMAE of each.
void LeaveOutStrangers(const std::vector<double>& errors, DiveOutcome* outcome) {
  constexpr double kMostTimes = 3.0, kMostNmae = 0.5;
  std::vector<double> known = errors;
  std::erase_if(known, [](double error) { return !std::isfinite(error); });
  if (known.empty()) return;
  const double usual = Median(known);
  std::vector<DiveLog> kept;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (errors[i] > std::max(kMostTimes * usual, kMostNmae)) {
      outcome->left_out.push_back(
          {outcome->logs[i].path,
           fmt::format(
               "the joint model simulates it with an NMAE of {:.2f}, the others with {:.2f}",
               errors[i],
               usual)});
    } else {
      kept.push_back(outcome->logs[i]);
    }
  }
  outcome->logs = std::move(kept);
}

// A file with this model, for whoever needs it next too.
fs::path FileOfModel(const std::string& model,
                     const std::string& digest,
                     const ProgramSettings& settings) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const fs::path file = settings.work / (digest + ".model.json");
  std::error_code error;
  if (!fs::exists(file, error)) WriteFile(file, model);
  return file;
}

}  // namespace

double PredictionNmae(const std::string& model,
                      const DiveLog& log,
                      const ProgramSettings& settings,
                      const RunBook& book) {
  const std::string digest = DigestOf(model);
  const fs::path file = FileOfModel(model, digest, settings);
  const RunRecord run = RunProgram({.program = "fathom_simulate",
                                    .contents = {digest, log.content},
                                    .flags = {},
                                    .places = {"--model=" + file.string(), "--log=" + log.place},
                                    .output = "json"},
                                   settings,
                                   book);
  return IsUsable(run) ? NumberIn(run.output, "/nmae") : std::numeric_limits<double>::quiet_NaN();
}

DiveOutcome RunDiveJobs(const DiveTask& task,
                        const ProgramSettings& settings,
                        const RunBook& book) {
  const JointFit fit = [&](const std::vector<DiveLog>& logs) {
    return Identify(task, logs, settings, book);
  };
  DiveOutcome outcome;
  outcome.logs = task.logs;
  if (outcome.logs.empty()) return outcome;
  outcome.identify = fit(outcome.logs);
  if (IsRefused(*outcome.identify) && outcome.logs.size() > 1) {
    LeaveOutRefused(fit, &outcome);
    if (outcome.logs.empty()) return outcome;
    outcome.identify = fit(outcome.logs);
  }
  const bool is_search_worth_it = outcome.logs.size() > 2 && outcome.logs.size() <= kMostRefits;
  if (!IsUsable(*outcome.identify) && is_search_worth_it) {
    LeaveOutTheOneThatSpoils(fit, &outcome);
    outcome.identify = fit(outcome.logs);
  }
  const Errors errors_of = [&](const std::string& model, const std::vector<DiveLog>& logs) {
    std::vector<double> errors;
    for (const DiveLog& log : logs) errors.push_back(PredictionNmae(model, log, settings, book));
    return errors;
  };
  while (IsUsable(*outcome.identify) && outcome.logs.size() > 2) {
    const std::vector<double> errors = errors_of(outcome.identify->output, outcome.logs);
    const bool is_small = outcome.logs.size() <= kMostRefits;
    const bool is_most = 3 * (outcome.left_out.size() + 1) <= task.logs.size();
    if (is_small && is_most && IsSpoiled(outcome.logs, errors) &&
        LeaveOutSpoiler(fit, errors_of, errors, &outcome)) {
      outcome.identify = fit(outcome.logs);
      continue;
    }
    LeaveOutStrangers(errors, &outcome);
    if (outcome.logs.size() < errors.size()) outcome.identify = fit(outcome.logs);
    break;
  }
  return outcome;
}

}  // namespace fathom
