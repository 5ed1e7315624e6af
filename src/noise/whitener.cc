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
  using Covariance = Eigen::Matrix<double, kNumStates, kNumStates>;
  template <int kWidth>
  using Row = Eigen::Array<double, kWidth, 1>;

  // Samples after the same interval, in the same channel, with the same noise: one transition, and
  // once the filter is stationary, one gain.
  struct Kind {
    double dt = -1.0, variance_factor = 0.0;
    NoiseChannel channel = NoiseChannel::kVelocity;
    bool is_filled = false;
    NoiseTransition transition;
    Covariance before, after;
    Step step;
    double log_variance = 0.0;
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
      kind->is_filled = false;
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

  static Covariance Start(const NoiseModel& model, const NoiseDynamics& dynamics) {
    Covariance P = Covariance::Zero();
    if constexpr (kHasV) {
      P(kW, kW) = dynamics.var_w();
      P(kW, kV) = P(kV, kW) = dynamics.cov_wv();
      P(kV, kV) = dynamics.var_v();
    }
    const auto square = [](double x) { return x * x; };
    if constexpr (kVelocityC) P(kC, kC) = square(model.velocity.coloured.std);
    if constexpr (kDisplacementC) P(kCx, kCx) = square(model.displacement.coloured.std);
    return P;
  }

  // P <- F P F' + Q, first the rows, then the columns.
  static void Predict(const NoiseTransition& t, Covariance* P) {
    const auto transform = [&](auto&& x) {
      if constexpr (kHasX) x(kX) += t.x_from_v * x(kV) + t.x_from_w * x(kW);
      if constexpr (kHasV) {
        x(kV) = t.v_from_v * x(kV) + t.v_from_w * x(kW);
        x(kW) *= t.w_from_w;
      }
      if constexpr (kVelocityC) x(kC) *= t.velocity_c;
      if constexpr (kDisplacementC) x(kCx) *= t.displacement_c;
    };
    for (int j = 0; j < kNumStates; ++j) transform(P->col(j));
    for (int i = 0; i < kNumStates; ++i) transform(P->row(i));
    if constexpr (kHasV) {
      (*P)(kW, kW) += t.q_ww;
      (*P)(kV, kW) = (*P)(kW, kV) += t.q_wv;
      (*P)(kV, kV) += t.q_vv;
    }
    if constexpr (kHasX) {
      (*P)(kX, kW) = (*P)(kW, kX) += t.q_wx;
      (*P)(kX, kV) = (*P)(kV, kX) += t.q_vx;
      (*P)(kX, kX) += t.q_xx;
    }
    if constexpr (kVelocityC) (*P)(kC, kC) += t.q_velocity_c;
    if constexpr (kDisplacementC) (*P)(kCx, kCx) += t.q_displacement_c;
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

  // P <- P less what one sample says; fills the gain and the innovation of `step`.
  static void Update(double white_variance, Covariance* P, Step* step, double* log_variance) {
    Eigen::Matrix<double, kNumStates, 1> seen = Eigen::Matrix<double, kNumStates, 1>::Zero();
    ForSeen(step->channel, [&](int i) { seen += P->col(i); });
    double variance = white_variance;
    ForSeen(step->channel, [&](int i) { variance += seen(i); });
    CHECK(variance > 0.0) << "A sample without a variance of its own: " << variance << ".";
    step->inverse_std = 1.0 / std::sqrt(variance);
    *log_variance = std::log(variance);
    seen *= step->inverse_std;
    for (int i = 0; i < kNumStates; ++i) step->gain[i] = seen(i);
    P->noalias() -= seen * seen.transpose();
  }

  static void FillSteps(const NoiseModel& model,
                        std::span<const NoiseSample> samples,
                        std::vector<Step>* steps,
                        std::vector<double>* log_variances) {
    Regimes regimes(model);
    Covariance P = Covariance::Zero();
    for (size_t i = 0; i < samples.size(); ++i) {
      const NoiseSample& sample = samples[i];
      const double white_std = sample.channel == NoiseChannel::kVelocity
                                   ? model.velocity.white_std
                                   : model.displacement.white_std;
      const double white_variance = sample.variance_factor * white_std * white_std;
      Step& step = (*steps)[i];
      if (i == 0 || sample.segment != samples[i - 1].segment) {
        P = Start(model, regimes.OfFactor(1.0)->dynamics);
        step = Step{};
        step.channel = sample.channel;
        Update(white_variance, &P, &step, &(*log_variances)[i]);
        continue;
      }
      const double dt = sample.time - samples[i - 1].time;
      CHECK(dt >= 0.0 && std::isfinite(dt)) << "Samples out of order at time " << sample.time;
      Kind* kind = regimes.OfFactor(sample.damping_factor)->KindOf(sample, dt);
      if (!kind->is_filled || !IsSame(kind->before, P)) {
        kind->is_filled = true;
        kind->before = P;
        const NoiseTransition& t = kind->transition;
        kind->step = {t.w_from_w,
                      t.v_from_w,
                      t.v_from_v,
                      t.x_from_w,
                      t.x_from_v,
                      1.0,
                      t.velocity_c,
                      t.displacement_c,
                      0.0,
                      {},
                      sample.channel};
        Predict(t, &P);
        Update(white_variance, &P, &kind->step, &kind->log_variance);
        kind->after = P;
      }
      P = kind->after;
      step = kind->step;
      (*log_variances)[i] = kind->log_variance;
    }
  }

  // W times kWidth columns that stand side by side; strides from one sample to the next.
  template <int kWidth>
  static void Apply(std::span<const Step> steps,
                    const double* in,
                    std::ptrdiff_t in_stride,
                    double* out,
                    std::ptrdiff_t out_stride) {
    std::array<Row<kWidth>, kNumStates> x;
    for (Row<kWidth>& state : x) state.setZero();
    for (const Step& step : steps) {
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
    : steps_(samples.size()), log_variances_(samples.size()) {
  const bool has_displacement = Has(samples, NoiseChannel::kDisplacement);
  const bool has_velocity = Has(samples, NoiseChannel::kVelocity);
  if (model.disturbance.IsPresent()) num_disturbance_states_ = has_displacement ? 3 : 2;
  has_velocity_c_ = has_velocity && model.velocity.coloured.IsPresent();
  has_displacement_c_ = has_displacement && model.displacement.coloured.IsPresent();
  WithFilter([&](auto filter) { filter.FillSteps(model, samples, &steps_, &log_variances_); });
  for (const double log_variance : log_variances_) log_determinant_ += log_variance;
}

void Whitener::Apply(std::span<const double> in, std::span<double> out) const {
  CHECK_EQ(in.size(), steps_.size());
  CHECK_EQ(out.size(), steps_.size());
  WithFilter([&](auto filter) { filter.template Apply<1>(steps_, in.data(), 1, out.data(), 1); });
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
            steps_, in.data() + column, in.outerStride(), out.data() + column, out.outerStride());
      }
    };
    apply.template operator()<8>();
    apply.template operator()<4>();
    apply.template operator()<1>();
  });
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
