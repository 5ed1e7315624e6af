// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/whitener.h"

#include "fathom/noise/noise_dynamics.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include <glog/logging.h>

namespace fathom {
namespace {

// Intervals that differ by less are the same [s]: the rounding of stamps of up to a day.
constexpr double kSameInterval = 2e-11;

// Samples of one kind before which the state is as uncertain as it was before the last one of that
// kind, to this relative precision, share their gains: the filter is stationary.
constexpr double kStationary = 1e-13;

bool Has(std::span<const NoiseSample> samples, NoiseChannel channel) {
  return std::any_of(samples.begin(), samples.end(), [channel](const NoiseSample& sample) {
    return sample.channel == channel;
  });
}

}  // namespace

// The Kalman filter of the model with the states that are needed, docs/residual_noise.md (7).
template <int kDisturbance, bool kVelocityC, bool kDisplacementC>
struct Whitener::Filter {
  static constexpr bool kHasV = kDisturbance >= 2, kHasX = kDisturbance == 3;
  static constexpr int kW = 0, kV = 1, kX = 2;
  static constexpr int kC = kDisturbance, kCx = kC + (kVelocityC ? 1 : 0);
  static constexpr int kNumStates = kCx + (kDisplacementC ? 1 : 0);
  using Covariance = Eigen::Matrix<double, kNumStates, kNumStates>;  // its lower half
  template <int kWidth>
  using Row = Eigen::Array<double, kWidth, 1>;

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

  // What is true at one damping rate, with the kinds met last.
  struct Regime {
    static constexpr int kNumKinds = 8;

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
      kind->transition = dynamics.Over(dt);
      return kind;
    }

    double damping_factor;
    NoiseDynamics dynamics;
    std::array<Kind, kNumKinds> kinds;
    int num_kinds = 0, next_kind = 0;
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

  static bool IsSame(const Covariance& P, const Covariance& other) {
    for (int i = 0; i < kNumStates; ++i) {
      for (int j = 0; j <= i; ++j) {
        // The scale of an entry is that of its variances, not its own: a covariance may vanish.
        const double difference = P(i, j) - other(i, j);
        if (!(difference * difference <= kStationary * kStationary * P(i, i) * P(j, j))) {
          return false;
        }
      }
    }
    return true;
  }

  // True if the state is now, behind `previous`, as it was before the last one of a kind.
  static bool IsSettled(Kind* kind, const Kind* previous, const Covariance& P) {
    if (previous == nullptr) return IsSame(kind->before, P);
    if (kind->settled_behind == previous && kind->settled_version == previous->version) return true;
    if (!IsSame(kind->before, P)) return false;
    kind->settled_behind = previous;
    kind->settled_version = previous->version;
    return true;
  }

  static Covariance Start(const NoiseModel& model, const NoiseDynamics& dynamics) {
    Covariance P = Covariance::Zero();
    if constexpr (kHasV) {
      P(kW, kW) = dynamics.var_w();
      P(kV, kW) = dynamics.cov_wv();
      P(kV, kV) = dynamics.var_v();
    }
    const auto square = [](double x) { return x * x; };
    if constexpr (kVelocityC) P(kC, kC) = square(model.velocity.coloured.std);
    if constexpr (kDisplacementC) P(kCx, kCx) = square(model.displacement.coloured.std);
    return P;
  }

  // P <- F P F' + Q.
  static void Predict(const NoiseTransition& t, Covariance* covariance) {
    Covariance& P = *covariance;
    if constexpr (kHasX) {
      // Row x of F P.
      const double xw = P(kX, kW) + t.x_from_v * P(kV, kW) + t.x_from_w * P(kW, kW);
      const double xv = P(kX, kV) + t.x_from_v * P(kV, kV) + t.x_from_w * P(kV, kW);
      const double xx = P(kX, kX) + t.x_from_v * P(kX, kV) + t.x_from_w * P(kX, kW);
      P(kX, kX) = xx + t.x_from_v * xv + t.x_from_w * xw + t.q_xx;
      P(kX, kV) = t.v_from_v * xv + t.v_from_w * xw + t.q_vx;
      P(kX, kW) = t.w_from_w * xw + t.q_wx;
    }
    if constexpr (kHasV) {
      const double vw = t.v_from_v * P(kV, kW) + t.v_from_w * P(kW, kW);
      const double vv = t.v_from_v * P(kV, kV) + t.v_from_w * P(kV, kW);
      P(kV, kV) = t.v_from_v * vv + t.v_from_w * vw + t.q_vv;
      P(kV, kW) = t.w_from_w * vw + t.q_wv;
      P(kW, kW) = t.w_from_w * t.w_from_w * P(kW, kW) + t.q_ww;
    }
    const auto with_coloured = [&](int c, double decay) {
      if constexpr (kHasX) {
        P(c, kX) = decay * (P(c, kX) + t.x_from_v * P(c, kV) + t.x_from_w * P(c, kW));
      }
      if constexpr (kHasV) {
        P(c, kV) = decay * (t.v_from_v * P(c, kV) + t.v_from_w * P(c, kW));
        P(c, kW) *= decay * t.w_from_w;
      }
    };
    if constexpr (kVelocityC) {
      with_coloured(kC, t.velocity_c);
      P(kC, kC) = t.velocity_c * t.velocity_c * P(kC, kC) + t.q_velocity_c;
    }
    if constexpr (kDisplacementC) {
      with_coloured(kCx, t.displacement_c);
      if constexpr (kVelocityC) P(kCx, kC) *= t.displacement_c * t.velocity_c;
      P(kCx, kCx) = t.displacement_c * t.displacement_c * P(kCx, kCx) + t.q_displacement_c;
    }
  }

  // The states that a channel sees, each with factor 1: calls function(index) for them.
  template <typename Function>
  static void ForSeen(NoiseChannel channel, const Function& function) {
    if (channel == NoiseChannel::kVelocity) {
      if constexpr (kHasV) function(kV);
      if constexpr (kVelocityC) function(kC);
    } else {
      if constexpr (kHasX) function(kX);
      if constexpr (kDisplacementC) function(kCx);
    }
  }

  // P <- P less what one sample says; fills the gain of `step` and returns the variance of its
  // innovation.
  static double Update(double white_variance, Covariance* covariance, Step* step) {
    Covariance& P = *covariance;
    std::array<double, kNumStates> seen{};
    ForSeen(step->channel, [&](int k) {
      for (int i = 0; i < kNumStates; ++i) seen[i] += i < k ? P(k, i) : P(i, k);
    });
    double variance = white_variance;
    ForSeen(step->channel, [&](int k) { variance += seen[k]; });
    CHECK(variance > 0.0) << "A sample without a variance of its own: " << variance << ".";
    step->inverse_std = 1.0 / std::sqrt(variance);
    for (int i = 0; i < kNumStates; ++i) step->gain[i] = seen[i] *= step->inverse_std;
    for (int i = 0; i < kNumStates; ++i) {
      for (int j = 0; j <= i; ++j) P(i, j) -= seen[i] * seen[j];
    }
    return variance;
  }

  // Returns log det S.
  static double FillSteps(const NoiseModel& model,
                          std::span<const NoiseSample> samples,
                          std::vector<int>* step_of,
                          std::vector<Step>* steps) {
    Regimes regimes(model);
    Covariance P = Covariance::Zero();
    const Kind* previous = nullptr;  // P is its `after`, unless a segment has just begun
    // Logarithms of products: of each variance they would take as long as all the rest.
    double log_determinant = 0.0, product = 1.0;
    for (size_t i = 0; i < samples.size(); ++i) {
      const NoiseSample& sample = samples[i];
      const double white_std = sample.channel == NoiseChannel::kVelocity
                                   ? model.velocity.white_std
                                   : model.displacement.white_std;
      const double white_variance = sample.variance_factor * white_std * white_std;
      if (i == 0 || sample.segment != samples[i - 1].segment) {
        P = Start(model, regimes.OfFactor(1.0)->dynamics);
        (*step_of)[i] = static_cast<int>(steps->size());
        Step& step = steps->emplace_back();
        step.channel = sample.channel;
        product *= Update(white_variance, &P, &step);
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
        const NoiseTransition& t = kind->transition;
        kind->last = static_cast<int>(steps->size());
        Step& step = steps->emplace_back(Step{t.w_from_w,
                                              t.v_from_w,
                                              t.v_from_v,
                                              t.x_from_w,
                                              t.x_from_v,
                                              1.0,
                                              t.velocity_c,
                                              t.displacement_c,
                                              0.0,
                                              {},
                                              sample.channel});
        Predict(t, &P);
        kind->variance = Update(white_variance, &P, &step);
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

  // W times kWidth columns that stand side by side; strides from one sample to the next.
  template <int kWidth>
  static void Apply(const Whitener& whitener,
                    const double* in,
                    std::ptrdiff_t in_stride,
                    double* out,
                    std::ptrdiff_t out_stride) {
    std::array<Row<kWidth>, kNumStates> x;
    for (Row<kWidth>& state : x) state.setZero();
    for (const int index : whitener.step_of_) {
      const Step& step = whitener.steps_[index];
      if constexpr (kHasX) {
        x[kX] = step.x_from_x * x[kX] + step.x_from_v * x[kV] + step.x_from_w * x[kW];
      }
      if constexpr (kHasV) {
        x[kV] = step.v_from_v * x[kV] + step.v_from_w * x[kW];
        x[kW] *= step.w_from_w;
      }
      if constexpr (kVelocityC) x[kC] *= step.velocity_c;
      if constexpr (kDisplacementC) x[kCx] *= step.displacement_c;
      Row<kWidth> innovation = Eigen::Map<const Row<kWidth>>(in);
      ForSeen(step.channel, [&](int i) { innovation -= x[i]; });
      innovation *= step.inverse_std;
      for (int i = 0; i < kNumStates; ++i) x[i] += step.gain[i] * innovation;
      Eigen::Map<Row<kWidth>>{out} = innovation;
      in += in_stride;
      out += out_stride;
    }
  }
};

// Calls function(Filter) with the filter that has the states needed.
template <typename Function>
void Whitener::WithFilter(const Function& function) const {
  const auto with_disturbance = [&]<bool kVelocityC, bool kDisplacementC>() {
    switch (num_disturbance_states_) {
      case 0:
        return function(Filter<0, kVelocityC, kDisplacementC>());
      case 2:
        return function(Filter<2, kVelocityC, kDisplacementC>());
      default:
        return function(Filter<3, kVelocityC, kDisplacementC>());
    }
  };
  if (has_velocity_c_) {
    has_displacement_c_ ? with_disturbance.template operator()<true, true>()
                        : with_disturbance.template operator()<true, false>();
  } else {
    has_displacement_c_ ? with_disturbance.template operator()<false, true>()
                        : with_disturbance.template operator()<false, false>();
  }
}

Whitener::Whitener(const NoiseModel& model, std::span<const NoiseSample> samples)
    : step_of_(samples.size()) {
  const bool has_displacement = Has(samples, NoiseChannel::kDisplacement);
  const bool has_velocity = Has(samples, NoiseChannel::kVelocity);
  if (model.disturbance.IsPresent()) num_disturbance_states_ = has_displacement ? 3 : 2;
  has_velocity_c_ = has_velocity && model.velocity.coloured.IsPresent();
  has_displacement_c_ = has_displacement && model.displacement.coloured.IsPresent();
  WithFilter([&](auto filter) {
    log_determinant_ = filter.FillSteps(model, samples, &step_of_, &steps_);
  });
}

void Whitener::Apply(std::span<const double> in, std::span<double> out) const {
  CHECK_EQ(in.size(), step_of_.size());
  CHECK_EQ(out.size(), step_of_.size());
  WithFilter([&](auto filter) { filter.template Apply<1>(*this, in.data(), 1, out.data(), 1); });
}

void Whitener::Apply(const Eigen::Ref<const RowMajorMatrix>& in,
                     Eigen::Ref<RowMajorMatrix> out) const {
  CHECK_EQ(in.rows(), num_samples());
  CHECK_EQ(out.rows(), num_samples());
  CHECK_EQ(in.cols(), out.cols());
  WithFilter([&](auto filter) {
    Eigen::Index column = 0;
    const auto apply = [&]<int kWidth>() {
      for (; column + kWidth <= in.cols(); column += kWidth) {
        filter.template Apply<kWidth>(
            *this, in.data() + column, in.outerStride(), out.data() + column, out.outerStride());
      }
    };
    apply.template operator()<8>();
    apply.template operator()<4>();
    apply.template operator()<1>();
  });
}

std::vector<double> Whitener::LogVariances() const {
  std::vector<double> of_steps;
  of_steps.reserve(steps_.size());
  for (const Step& step : steps_) of_steps.push_back(-2.0 * std::log(step.inverse_std));
  std::vector<double> log_variances;
  log_variances.reserve(step_of_.size());
  for (const int step : step_of_) log_variances.push_back(of_steps[step]);
  return log_variances;
}

double Whitener::LogLikelihood(std::span<const double> residual) const {
  std::vector<double> whitened(residual.size());
  Apply(residual, whitened);
  double sum_of_squares = 0.0;
  for (const double e : whitened) sum_of_squares += e * e;
  const double n = static_cast<double>(residual.size());
  return -0.5 * (sum_of_squares + log_determinant_ + n * std::log(2.0 * std::numbers::pi));
}

}  // namespace fathom
