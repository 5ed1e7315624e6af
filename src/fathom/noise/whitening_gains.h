// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/state_covariance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <iterator>
#include <span>
#include <vector>

#include <glog/logging.h>

namespace fathom {

// The steps of a Whitener with these states: the Kalman filter's gains, which depend on the
// sampling only and settle where that repeats itself.
template <typename States>
class WhiteningGains {
 public:
  // Appends the steps, and fills which one each sample takes. Returns log det S.
  static double FillSteps(const NoiseModel& model,
                          std::span<const NoiseSample> samples,
                          std::vector<int>* step_of,
                          std::vector<WhiteningStep>* steps) {
    Regimes regimes(model);
    Covariance P = Covariance::Zero();
    const Kind* previous = nullptr;  // P is its `after`, unless a segment has just begun
    // Logarithms of products: of each variance they would take as long as all the rest.
    double log_determinant = 0.0, product = 1.0;
    for (size_t i = 0; i < samples.size(); ++i) {
      const NoiseSample& sample = samples[i];
      const double white_variance = WhiteVariance(model, sample);
      if (i == 0 || sample.segment != samples[i - 1].segment) {
        P = Base::Start(model, regimes.OfFactor(1.0)->dynamics);
        (*step_of)[i] = static_cast<int>(steps->size());
        WhiteningStep& step = steps->emplace_back();
        step.channel = sample.channel;
        product *= Base::Update(white_variance, &P, &step);
        previous = nullptr;
        continue;
      }
      const double dt = sample.time - samples[i - 1].time;
      CHECK(dt >= 0.0 && std::isfinite(dt)) << "Samples out of order at time " << sample.time;
      Kind* kind = regimes.OfFactor(sample.damping_factor)->KindOf(sample, dt);
      if (kind->last >= 0 && IsSettled(kind, previous, P)) {
        P = kind->after;
      } else {
        kind->before = P;
        kind->last = static_cast<int>(steps->size());
        WhiteningStep& step = steps->emplace_back(StepOver(kind->transition, sample.channel));
        Base::Predict(kind->transition, &P);
        kind->variance = Base::Update(white_variance, &P, &step);
        kind->after = P;
        ++kind->version;
        kind->settled_behind = nullptr;
      }
      (*step_of)[i] = kind->last;
      previous = kind;
      product *= kind->variance;
      if (!(product > 1e-100 && product < 1e100)) {
        log_determinant += std::log(product);
        product = 1.0;
      }
    }
    return log_determinant + std::log(product);
  }

 private:
  using Base = StateCovariance<States>;
  using Covariance = typename Base::Covariance;

  // Intervals that differ by less are the same [s]: the rounding of stamps of up to a day.
  static constexpr double kSameInterval = 2e-11;

  // Samples after the same interval, in the same channel, with the same noise: one transition, and
  // once the filter is stationary, one gain.
  struct Kind {
    double dt = -1.0, variance_factor = 0.0;
    NoiseChannel channel = NoiseChannel::kVelocity;
    NoiseTransition transition;
    int last = -1;             // step of the last one of this kind
    Covariance before, after;  // there
    double variance = 0.0;     // there
    int version = 0;           // of `after`
    // Whose `after` was last found to be as `before`, and which version of it: looking again would
    // take as long as all the rest.
    const Kind* settled_behind = nullptr;
    int settled_version = 0;
  };

  struct Interval {
    double dt;
    NoiseTransition transition;
  };

  // What is true at one damping rate, with the kinds met last.
  struct Regime {
    static constexpr int kNumKinds = 32;

    Regime(const NoiseModel& model, double factor)
        : damping_factor(factor), dynamics(model, factor) {}

    Kind* KindOf(const NoiseSample& sample, double dt) {
      const auto is_kind = [&](const Kind& kind) {
        return std::abs(kind.dt - dt) < kSameInterval && kind.channel == sample.channel &&
               kind.variance_factor == sample.variance_factor;
      };
      Kind* const end = kinds.data() + num_kinds;
      Kind* kind = std::find_if(kinds.data(), end, is_kind);
      if (kind != end) return kind;
      if (num_kinds < kNumKinds) {
        ++num_kinds;
      } else {
        kind = &kinds[next_kind++ % kNumKinds];
      }
      kind->dt = dt;
      kind->variance_factor = sample.variance_factor;
      kind->channel = sample.channel;
      kind->last = -1;
      kind->transition = TransitionOver(dt);
      return kind;
    }

    // Kinds share their intervals: a transition takes as long as what the filter does with it.
    const NoiseTransition& TransitionOver(double dt) {
      const auto known = std::find_if(intervals.begin(), intervals.end(), [dt](const Interval& of) {
        return std::abs(of.dt - dt) < kSameInterval;
      });
      if (known != intervals.end()) return known->transition;
      if (std::ssize(intervals) == kNumKinds) intervals.clear();
      intervals.push_back({dt, dynamics.Over(dt)});
      return intervals.back().transition;
    }

    double damping_factor;
    NoiseDynamics dynamics;
    std::array<Kind, kNumKinds> kinds;
    int num_kinds = 0, next_kind = 0;
    std::vector<Interval> intervals;  // those met last
  };

  class Regimes {
   public:
    explicit Regimes(const NoiseModel& model) : model_(model) {}

    Regime* OfFactor(double factor) {
      if (last_ != nullptr && last_->damping_factor == factor) return last_;
      const auto found = std::find_if(all_.begin(), all_.end(), [factor](const Regime& regime) {
        return regime.damping_factor == factor;
      });
      last_ = found != all_.end() ? &*found : &all_.emplace_back(model_, factor);
      return last_;
    }

   private:
    const NoiseModel& model_;
    std::deque<Regime> all_;  // does not move what it holds
    Regime* last_ = nullptr;
  };

  // True if the state is now, behind `previous`, as it was before the last one of a kind.
  static bool IsSettled(Kind* kind, const Kind* previous, const Covariance& P) {
    if (previous == nullptr) return Base::IsSame(kind->before, P);
    if (kind->settled_behind == previous && kind->settled_version == previous->version) return true;
    if (!Base::IsSame(kind->before, P)) return false;
    kind->settled_behind = previous;
    kind->settled_version = previous->version;
    return true;
  }

  static double WhiteVariance(const NoiseModel& model, const NoiseSample& sample) {
    const double white_std = sample.channel == NoiseChannel::kVelocity
                                 ? model.velocity.white_std
                                 : model.displacement.white_std;
    return sample.variance_factor * white_std * white_std;
  }

  // Still without its gain.
  static WhiteningStep StepOver(const NoiseTransition& t, NoiseChannel channel) {
    return {t.w_from_w,
            t.v_from_w,
            t.v_from_v,
            t.x_from_w,
            t.x_from_v,
            1.0,
            t.velocity_c,
            t.displacement_c,
            0.0,
            {},
            channel};
  }
};

}  // namespace fathom
