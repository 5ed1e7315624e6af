// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/trial_values.h"

#include "fathom/diagnosis/fit/parameter_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace fathom {
namespace {

constexpr double kProbe = 0.02;   // of the natural size, where an effect names no other
constexpr double kSpacing = 5.0;  // [s], of times of the run that are tried
constexpr int kFewestTimes = 10, kMostTimes = 80;
// Of slower frequencies there are too few periods to tell them from a wandering force.
constexpr double kFewestPeriods = 4.0;
constexpr double kFastest = 3.0;  // [rad/s], of frequencies that are tried
constexpr size_t kMostFrequencies = 250;

double NaturalSize(const Quantity& quantity, const RunScale& scale) {
  return std::pow(scale.force, quantity.force) * std::pow(scale.speed, quantity.speed);
}

// Times of one log, or of all where it has no name.
void SetTimes(const TrainingData& data, const std::string& log, RunScale* scale) {
  scale->first_time = std::numeric_limits<double>::infinity();
  scale->last_time = -std::numeric_limits<double>::infinity();
  for (const MeasuredSegment& segment : data.segments()) {
    if (!log.empty() && segment.log != log) continue;
    const double start = segment.stamps.start - segment.inputs->command.time.front();
    scale->first_time = std::min(scale->first_time, start);
    scale->last_time = std::max(scale->last_time, start + segment.duration());
  }
}

// As many of the parameter's own trials as lie within its bounds.
std::vector<double> TrialsWithin(const EffectParameter& parameter,
                                 const ParameterBounds& bounds,
                                 double natural) {
  std::vector<double> values;
  for (const double trial : parameter.trials) {
    const double value = trial * natural;
    if (value > bounds.lower && value < bounds.upper) values.push_back(value);
  }
  return values;
}

std::vector<double> TimesOf(const RunScale& scale) {
  std::vector<double> values;
  const double spacing = SpacingOfTimes(scale);
  for (double t = scale.first_time + spacing; t < scale.last_time - 0.5 * spacing; t += spacing) {
    values.push_back(t);
  }
  return values;
}

std::vector<double> FrequenciesOf(const RunScale& scale) {
  std::vector<double> values;
  const double span = scale.last_time - scale.first_time;
  const double step = 1.3 * std::numbers::pi / span;
  const double slowest = kFewestPeriods * 2.0 * std::numbers::pi / span;
  for (double w = slowest; w < kFastest && values.size() < kMostFrequencies; w += step) {
    values.push_back(w);
  }
  return values;
}

}  // namespace

RunScale MeasuredScale(const TrainingData& data) {
  double force = 0.0, speed = 0.0, n = 0.0;
  for (const MeasuredSegment& segment : data.segments()) {
    const Segment plain = PlainSegment(segment);
    for (size_t i = 0; i < plain.time.size(); ++i, n += 1.0) {
      const double command = plain.command.At(plain.time[i]);
      force += command * command;
      speed += plain.velocity[i] * plain.velocity[i];
    }
  }
  RunScale scale = {.force = std::max(1e-9, std::sqrt(force / n)),
                    .speed = std::max(1e-9, std::sqrt(speed / n))};
  SetTimes(data, "", &scale);
  return scale;
}

RunScale ScaleOf(const TrainingData& data, const ForceResponse& response, const Suspect& suspect) {
  RunScale scale;
  double force = 0.0, speed = 0.0;
  for (const RunPoint& point : response.points()) {
    force += point.command * point.command;
    speed += point.velocity * point.velocity;
  }
  const auto n = static_cast<double>(response.points().size());
  scale.force = std::max(1e-9, std::sqrt(force / n));
  scale.speed = std::max(1e-9, std::sqrt(speed / n));
  SetTimes(data, suspect.setting.log, &scale);
  return scale;
}

double SpacingOfTimes(const RunScale& scale) {
  const double span = scale.last_time - scale.first_time;
  return span / std::clamp(static_cast<int>(span / kSpacing), kFewestTimes, kMostTimes);
}

std::vector<double> ValuesToTry(const EffectParameter& parameter,
                                const TrainingData& data,
                                const RunScale& scale) {
  const double natural = NaturalSize(parameter.quantity, scale);
  switch (parameter.search) {
    case Search::kAmount: {
      const double probe = natural * (parameter.trials.empty() ? kProbe : parameter.trials[0]);
      return {parameter.null + probe};
    }
    case Search::kSize:
    case Search::kShape:
      return TrialsWithin(parameter, BoundsOf(parameter, data), natural);
    case Search::kTimeOfRun:
      return TimesOf(scale);
    case Search::kFrequencyOfRun:
      return FrequenciesOf(scale);
  }
  return {};
}

std::vector<std::vector<double>> CombinationsOf(const EffectInfo& info,
                                                const TrainingData& data,
                                                const RunScale& scale) {
  std::vector<std::vector<double>> combinations = {{}};
  for (const EffectParameter& parameter : info.parameters) {
    std::vector<std::vector<double>> longer;
    for (const auto& begun : combinations) {
      for (const double value : ValuesToTry(parameter, data, scale)) {
        longer.push_back(begun);
        longer.back().push_back(value);
      }
    }
    combinations = std::move(longer);
  }
  return combinations;
}

}  // namespace fathom
