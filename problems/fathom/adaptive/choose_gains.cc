// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/choose_gains.h"

#include "fathom/adaptive/adaptive_identifier.h"
#include "fathom/adaptive/pass.h"
#include "fathom/signal/filters/dominant_tone.h"
#include "fathom/simulate/simulate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fathom {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFewestPeriods = 5.0;  // of the motion in the data, for the scale of the search
constexpr int kNumRefinements = 4;

// Mean squares of the four regressors.
struct MeanSquares {
  double force = 0.0;
  double drag = 0.0;
  double velocity = 0.0;
};

// docs/adaptive.md (3): one common rate [1/s^2] in units in which every regressor has mean
// square 1.
AdaptiveGains GainsOf(double damping, double rate, const MeanSquares& scale) {
  return {-damping, {rate / scale.force, rate / scale.drag, rate / scale.velocity, rate}};
}

// A point of the search: logarithms of -a_m and of the rate.
struct Point {
  double log_damping = 0.0;
  double log_rate = 0.0;
};

class Search {
 public:
  explicit Search(std::span<const Segment> segments) : pass_(PassOver(segments)) {
    double n = 0.0;
    for (const PassSegment& segment : pass_) {
      for (size_t i = 0; i < segment.time.size(); ++i, n += 1.0) {
        const double v_squared = segment.velocity[i] * segment.velocity[i];
        scale_.force += segment.force[i] * segment.force[i];
        scale_.velocity += v_squared;
        scale_.drag += v_squared * v_squared;
      }
    }
    scale_.force /= n;
    scale_.velocity /= n;
    scale_.drag /= n;
    for (const PassSegment& segment : pass_) {
      runs_.emplace_back(HeldCommand{segment.time, segment.force}, segment.time);
    }
  }

  bool HasMotion() const {
    return scale_.force > 0.0 && scale_.drag > 0.0 && std::isfinite(scale_.force) &&
           std::isfinite(scale_.drag);
  }

  AdaptiveGains GainsAt(const Point& point) const {
    return GainsOf(std::exp(point.log_damping), std::exp(point.log_rate), scale_);
  }

  // Sum of squares of what the free run of the final model misses; infinite if it diverges.
  double Score(const Point& point) {
    AdaptiveIdentifier identifier({.gains = GainsAt(point)});
    Feed(pass_, &identifier, [] {});
    if (!identifier.IsFinite()) return kInfinity;
    const UncoupledModel<double> model = identifier.Estimate();
    double sum = 0.0;
    for (size_t k = 0; k < pass_.size(); ++k) {
      const std::vector<double>& measured = pass_[k].velocity;
      simulated_.resize(measured.size());
      if (!runs_[k].Run(model, {pass_[k].initial_velocity, 0.0}, simulated_, {})) return kInfinity;
      for (size_t i = 0; i < measured.size(); ++i) {
        sum += (simulated_[i] - measured[i]) * (simulated_[i] - measured[i]);
      }
    }
    return std::isfinite(sum) ? sum : kInfinity;
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

 private:
  std::vector<PassSegment> pass_;
  std::vector<Simulation> runs_;
  MeanSquares scale_;
  std::vector<double> simulated_;
};

// Frequency of the motion [rad/s], by the strongest line of the longest segment's command.
double FrequencyOf(std::span<const Segment> segments) {
  const Segment& longest =
      *std::max_element(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
        return a.time.size() < b.time.size();
      });
  const double duration = longest.time.back() - longest.time.front();
  const double lowest = 2.0 * kPi * kFewestPeriods / duration;
  const Tone tone = DominantTone(longest.command, duration);
  return std::isfinite(tone.frequency) ? std::max(tone.frequency, lowest) : lowest;
}

}  // namespace

AdaptiveGains ChooseGains(std::span<const Segment> segments) {
  const bool has_samples =
      std::any_of(segments.begin(), segments.end(), [](const Segment& segment) {
        return segment.time.size() > 2 && !segment.command.time.empty();
      });
  if (!has_samples) return {};
  Search search(segments);
  if (!search.HasMotion()) return {};

  const double frequency = FrequencyOf(segments);
  Point best;
  double best_score = Search::kInfinity;
  const auto consider = [&](const Point& point) {
    const double score = search.Score(point);
    if (!(score < best_score)) return;
    best_score = score;
    best = point;
  };
  for (const double damping : {0.03, 0.1, 0.3, 1.0, 3.0}) {
    for (const double rate : {0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0}) {
      consider({std::log(damping * frequency), std::log(rate * frequency * frequency)});
    }
  }
  if (best_score == Search::kInfinity) return {};
  double step = 0.5 * std::log(3.0);
  for (int k = 0; k < kNumRefinements; ++k, step *= 0.5) {
    const Point middle = best;
    for (const double sideways : {-step, 0.0, step}) {
      for (const double upwards : {-step, 0.0, step}) {
        if (sideways == 0.0 && upwards == 0.0) continue;
        consider({middle.log_damping + sideways, middle.log_rate + upwards});
      }
    }
  }
  return search.GainsAt(best);
}

}  // namespace fathom
