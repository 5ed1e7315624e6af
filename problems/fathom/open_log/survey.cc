// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/open_log/survey.h"

#include "fathom/base/files/json_text.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/base/short_number.h"
#include "fathom/log/log.h"
#include "fathom/marker_trajectory/camera_source.h"
#include "fathom/open_log/open_log.h"
#include "fathom/signal/signals.h"
#include "fathom/signal/sources/choose_source.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

constexpr std::size_t kFewestSamples = 20;
constexpr double kShortest = 3.0;  // [s]

using Json = nlohmann::ordered_json;

bool HasImages(const Log& log) {
  std::error_code error;
  return !log.video.empty() || std::filesystem::exists(log.path / "frames.csv", error);
}

bool HasConstantCommand(const std::vector<Segment>& segments) {
  const double first = segments.front().command.value.front();
  return std::all_of(segments.begin(), segments.end(), [&](const Segment& segment) {
    return std::all_of(segment.command.value.begin(),
                       segment.command.value.end(),
                       [&](double value) { return value == first; });
  });
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Whiteness {
  double sum_of_squares = 0.0;  // about the mean of each segment
  double sum_of_steps = 0.0;    // squared, from sample to sample
  std::size_t count = 0;
  double slowest = kInfinity;  // the smallest mean speed of a segment; of positions 0
};

// The positions where there are any: speeds derived from poses are smoothed, and never white.
Whiteness WhitenessOf(const std::vector<Segment>& segments) {
  Whiteness sums;
  for (const Segment& segment : segments) {
    const auto& motion = segment.position.empty() ? segment.velocity : segment.position;
    double mean = 0.0;
    for (const double value : motion) mean += value / static_cast<double>(motion.size());
    for (std::size_t i = 0; i < motion.size(); ++i) {
      sums.sum_of_squares += (motion[i] - mean) * (motion[i] - mean);
      if (i > 0) sums.sum_of_steps += (motion[i] - motion[i - 1]) * (motion[i] - motion[i - 1]);
    }
    sums.count += motion.size();
    sums.slowest = std::min(sums.slowest, segment.position.empty() ? std::abs(mean) : 0.0);
  }
  return sums;
}

// Von Neumann's ratio of white noise is 2, with a standard deviation of 2 / sqrt(n). (J. von
// Neumann, Annals of Mathematical Statistics 12, 1941.)
bool IsWhite(const Whiteness& sums) {
  constexpr double kMostDeviations = 4.0;
  const double ratio = sums.sum_of_steps / sums.sum_of_squares;
  return (2.0 - ratio) * std::sqrt(static_cast<double>(sums.count)) / 2.0 < kMostDeviations;
}

// The root mean square of a column about its mean; NaN of one that is short, at rest or white.
double MotionOf(const std::vector<double>& column) {
  std::vector<double> known = column;
  std::erase_if(known, [](double value) { return !std::isfinite(value); });
  if (known.size() < kFewestSamples) return std::nan("");
  Segment segment;
  segment.velocity = known;
  const Whiteness sums = WhitenessOf({segment});
  if (!(sums.sum_of_steps > 0.0) || IsWhite(sums)) return std::nan("");
  return std::sqrt(sums.sum_of_squares / static_cast<double>(sums.count));
}

std::vector<UndrivenDof> UndrivenOf(const Log& log, const std::vector<Dof>& candidates) {
  std::vector<UndrivenDof> undriven;
  for (const Dof dof : kAllDofs) {
    const auto* column = log.velocity ? log.velocity->Find(VelocityColumn(dof)) : nullptr;
    const double motion = column ? MotionOf(*column) : std::nan("");
    if (std::isnan(motion)) continue;
    const auto* force = log.command ? log.command->Find(ForceColumn(dof)) : nullptr;
    const bool is_driven =
        force && std::ranges::any_of(*force, [](double value) { return value != 0.0; });
    const bool is_candidate = std::ranges::count(candidates, dof) > 0;
    if (is_driven && is_candidate) continue;
    undriven.push_back({dof,
                        fmt::format("moves by {} {}, {}.",
                                    ShortNumber(motion, 2),
                                    VelocityUnit(dof),
                                    is_driven ? "and `dof` in log.yaml does not name it"
                                              : "and nothing commands it")});
  }
  return undriven;
}

SurveyedDof LookAt(const Signals& signals) {
  std::size_t count = 0;
  double duration = 0.0;
  for (const Segment& segment : signals.train) {
    count += segment.time.size();
    duration += segment.time.back() - segment.time.front();
  }
  const auto no = [&](std::string why) { return SurveyedDof{signals.dof, std::move(why), false}; };
  if (IsAllHeldOut(signals)) return no(std::string(kAllIsHeldOut));
  if (count < kFewestSamples || duration < kShortest) {
    return no(fmt::format("too short: {} samples over {:.1f} s, expected at least {} over {} s.",
                          count,
                          duration,
                          kFewestSamples,
                          kShortest));
  }
  const Whiteness sums = WhitenessOf(signals.train);
  // Its mean is rounded, the difference of two equal values is not.
  if (!(sums.sum_of_steps > 0.0)) return no("at rest: the motion never changes.");
  if (IsWhite(sums)) {
    const double scatter = std::sqrt(sums.sum_of_squares / static_cast<double>(sums.count));
    return no(sums.slowest > scatter
                  ? fmt::format("steady: the speed is {:.3g} {} and white noise.",
                                sums.slowest,
                                VelocityUnit(signals.dof))
                  : "at rest: the motion is no more than white noise.");
  }
  if (!HasConstantCommand(signals.train)) return {signals.dof, "", true};
  return {signals.dof,
          fmt::format("the command never changes: it is {} {} throughout.",
                      signals.train.front().command.value.front(),
                      signals.force_unit),
          true};
}

// Of a DOF that no force of the command acts on.
std::string WhyNoForce(const Log& log) {
  if (!log.fins && !log.shafts) return "no command.";
  return fmt::format(
      "{}, which a model of one DOF does not hold: fathom_identify --dofs, docs/fins.md.",
      log.shafts ? "shafts drive it" : "fins alone steer it");
}

SurveyedDof LookAt(const Log& log, Dof dof) {
  if (!log.command || log.command->Find(ForceColumn(dof)) == nullptr) {
    return {dof, WhyNoForce(log), false};
  }
  if (SourcesOf(log, dof).empty()) return {dof, "no measured motion.", false};
  try {
    return LookAt(SignalsOf(log, dof, {.source = BestSourceOf(log, dof)}));
  } catch (const InputError& error) {
    return {dof, error.what(), false};
  }
}

std::vector<Dof> CandidatesOf(const Log& log) {
  if (!log.dofs.empty()) return log.dofs;
  std::vector<Dof> dofs;
  for (const Dof dof : kAllDofs) {
    if (log.command && log.command->Find(ForceColumn(dof)) != nullptr) dofs.push_back(dof);
  }
  return dofs;
}

const Stream* MainStream(const Log& log) {
  for (const auto* stream : {&log.velocity, &log.pose, &log.detections, &log.command}) {
    if (*stream) return &**stream;
  }
  return nullptr;
}

// Stamps beyond this are no seconds since a computer was switched on: 2001.
constexpr double kFirstEpoch = 1e9;

}  // namespace

Survey SurveyLog(const std::filesystem::path& path,
                 std::optional<Dof> dof,
                 const std::filesystem::path& default_vehicle) {
  Log log = OpenLog(
      path, {.dof = dof, .may_lack_motion = true, .may_lack_command = true}, default_vehicle);
  const bool has_default =
      !default_vehicle.empty() && log.vehicle == std::filesystem::absolute(default_vehicle);
  Survey survey = SurveyOf(std::move(log));
  if (has_default) survey.vehicle.clear();
  return survey;
}

Survey SurveyOf(Log log) {
  Survey survey;
  survey.dive = log.dive;
  survey.vehicle = log.vehicle;
  survey.start = log.start.value_or(std::numeric_limits<double>::quiet_NaN());
  if (const Stream* stream = MainStream(log)) {
    survey.duration = stream->time.back() - stream->time.front();
    if (!log.start && stream->time.front() > kFirstEpoch) survey.start = stream->time.front();
  }
  const std::vector<Dof> candidates = CandidatesOf(log);
  const bool has_motion = log.velocity || log.pose;
  survey.needs_tracking =
      !has_motion && !log.detections && HasImages(log) && log.command && !candidates.empty();
  if (survey.needs_tracking) return survey;
  if (!has_motion && log.detections && log.command) TrackDetections(&log);
  for (const Dof candidate : candidates) survey.dofs.push_back(LookAt(log, candidate));
  survey.undriven = UndrivenOf(log, candidates);
  return survey;
}

std::string FormatSurvey(const Survey& survey) {
  Json dofs = Json::array();
  for (const SurveyedDof& dof : survey.dofs) {
    dofs.push_back(
        {{"dof", Name(dof.dof)}, {"why_not", CleanText(dof.why_not)}, {"may_help", dof.may_help}});
  }
  Json undriven = Json::array();
  for (const UndrivenDof& dof : survey.undriven) {
    undriven.push_back({{"dof", Name(dof.dof)}, {"why", dof.why}});
  }
  const Json json = {{"schema", "fathom-survey-1"},
                     {"dive", survey.dive},
                     {"vehicle", survey.vehicle},
                     {"start", survey.start},
                     {"duration", survey.duration},
                     {"needs_tracking", survey.needs_tracking},
                     {"dofs", dofs},
                     {"undriven", undriven}};
  return JsonText(json);
}

Survey ParseSurvey(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    const auto number = [&](const char* key) {
      return json.at(key).is_null() ? std::numeric_limits<double>::quiet_NaN()
                                    : json.at(key).get<double>();
    };
    Survey survey;
    survey.dive = json.at("dive").get<std::string>();
    survey.vehicle = json.at("vehicle").get<std::string>();
    survey.start = number("start");
    survey.duration = number("duration");
    survey.needs_tracking = json.at("needs_tracking").get<bool>();
    // Surveys that an archive keeps may be older than this key.
    for (const Json& dof : json.value("undriven", Json::array())) {
      survey.undriven.push_back(
          {ParseDof(dof.at("dof").get<std::string>()), dof.at("why").get<std::string>()});
    }
    for (const Json& dof : json.at("dofs")) {
      survey.dofs.push_back({ParseDof(dof.at("dof").get<std::string>()),
                             dof.at("why_not").get<std::string>(),
                             dof.at("may_help").get<bool>()});
    }
    return survey;
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("is no survey of a log: {}.", error.what()));
  }
}

}  // namespace fathom
