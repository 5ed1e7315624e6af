// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/whitener.h"

#include "fathom/base/flattened.h"
#include "fathom/base/tiny_as_zero.h"
#include "fathom/noise/filter_states.h"
#include "fathom/noise/whitening_gains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include <glog/logging.h>

namespace fathom {
namespace {

bool Has(std::span<const NoiseSample> samples, NoiseChannel channel) {
  return std::any_of(samples.begin(), samples.end(), [channel](const NoiseSample& sample) {
    return sample.channel == channel;
  });
}

// W times kWidth columns that stand side by side; strides from one sample to the next. Flattened:
// the compiler would call some of Eigen's one-line functions, at a tenth of a whole diagnosis.
template <typename States, int kWidth>
FATHOM_FLATTENED void ApplyColumns(std::span<const int> step_of,
                                   const std::vector<WhiteningStep>& steps,
                                   const double* in,
                                   std::ptrdiff_t in_stride,
                                   double* out,
                                   std::ptrdiff_t out_stride) {
  using Row = Eigen::Array<double, kWidth, 1>;
  using S = States;
  std::array<Row, S::kNumStates> x;
  for (Row& state : x) state.setZero();
  for (const int index : step_of) {
    const WhiteningStep& step = steps[index];
    if constexpr (S::kHasX) {
      x[S::kX] = step.x_from_x * x[S::kX] + step.x_from_v * x[S::kV] + step.x_from_w * x[S::kW];
    }
    if constexpr (S::kHasV) {
      x[S::kV] = step.v_from_v * x[S::kV] + step.v_from_w * x[S::kW];
      x[S::kW] *= step.w_from_w;
    }
    if constexpr (S::kHasC) x[S::kC] *= step.velocity_c;
    if constexpr (S::kHasCx) x[S::kCx] *= step.displacement_c;
    Row innovation = Eigen::Map<const Row>(in);
    S::ForSeen(step.channel, [&](int i) { innovation -= x[i]; });
    innovation *= step.inverse_std;
    for (int i = 0; i < S::kNumStates; ++i) x[i] += step.gain[i] * innovation;
    Eigen::Map<Row>{out} = innovation;
    in += in_stride;
    out += out_stride;
  }
}

}  // namespace

// Calls function(FilterStates) with the states needed.
template <typename Function>
void Whitener::WithStates(const Function& function) const {
  const auto with_disturbance = [&]<bool kVelocityC, bool kDisplacementC>() {
    switch (num_disturbance_states_) {
      case 0:
        return function(FilterStates<0, kVelocityC, kDisplacementC>());
      case 2:
        return function(FilterStates<2, kVelocityC, kDisplacementC>());
      default:
        return function(FilterStates<3, kVelocityC, kDisplacementC>());
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
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i == 0 || samples[i].segment != samples[i - 1].segment) {
      first_rows_.push_back(static_cast<int>(i));
    }
  }
  first_rows_.push_back(num_samples());
  // Under stamps that jitter every sample has a step of its own: growing would copy them again and
  // again. What is not used is never touched.
  steps_.reserve(samples.size());
  WithStates([&](auto states) {
    log_determinant_ =
        WhiteningGains<decltype(states)>::FillSteps(model, samples, &step_of_, &steps_);
  });
}

void Whitener::Apply(std::span<const double> in, std::span<double> out) const {
  CHECK_EQ(in.size(), step_of_.size());
  CHECK_EQ(out.size(), step_of_.size());
  WithStates([&](auto states) {
    ApplyColumns<decltype(states), 1>(step_of_, steps_, in.data(), 1, out.data(), 1);
  });
}

void Whitener::ApplySteps(std::span<const int> step_of,
                          const Eigen::Ref<const RowMajorMatrix>& in,
                          Eigen::Ref<RowMajorMatrix> out) const {
  const TinyAsZero tiny_as_zero;
  CHECK_EQ(in.rows(), std::ssize(step_of));
  CHECK_EQ(out.rows(), in.rows());
  CHECK_EQ(in.cols(), out.cols());
  WithStates([&](auto states) {
    Eigen::Index column = 0;
    const auto apply = [&]<int kWidth>() {
      for (; column + kWidth <= in.cols(); column += kWidth) {
        ApplyColumns<decltype(states), kWidth>(step_of,
                                               steps_,
                                               in.data() + column,
                                               in.outerStride(),
                                               out.data() + column,
                                               out.outerStride());
      }
    };
    apply.template operator()<8>();
    apply.template operator()<4>();
    apply.template operator()<1>();
  });
}

void Whitener::Apply(const Eigen::Ref<const RowMajorMatrix>& in,
                     Eigen::Ref<RowMajorMatrix> out) const {
  ApplySteps(step_of_, in, out);
}

void Whitener::ApplyToSegment(std::size_t index,
                              const Eigen::Ref<const RowMajorMatrix>& in,
                              Eigen::Ref<RowMajorMatrix> out) const {
  const int begin = first_rows_[index], end = first_rows_[index + 1];
  ApplySteps(std::span(step_of_).subspan(begin, end - begin), in, out);
}

std::vector<double> Whitener::LogVariances() const {
  std::vector<double> of_steps;
  of_steps.reserve(steps_.size());
  for (const WhiteningStep& step : steps_) of_steps.push_back(-2.0 * std::log(step.inverse_std));
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
