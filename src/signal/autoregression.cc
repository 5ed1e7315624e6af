// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/autoregression.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fathom {
namespace {

// So many orders without a better criterion end the search for one.
constexpr int kPatience = 10;

// Forward and backward prediction errors of one piece, as Burg's recursion carries them.
struct PredictionErrors {
  std::vector<double> forward;
  std::vector<double> backward;
};

// The reflection coefficient that minimises both prediction errors of the next order.
double Reflection(const std::vector<PredictionErrors>& pieces, int order) {
  double cross = 0.0, power = 0.0;
  for (const auto& [forward, backward] : pieces) {
    for (size_t i = order + 1; i < forward.size(); ++i) {
      cross += forward[i] * backward[i - 1];
      power += forward[i] * forward[i] + backward[i - 1] * backward[i - 1];
    }
  }
  return power > 0.0 ? 2.0 * cross / power : 0.0;
}

void Advance(double reflection, int order, PredictionErrors* errors) {
  auto& [forward, backward] = *errors;
  for (size_t i = forward.size(); i-- > static_cast<size_t>(order) + 1;) {
    const double f = forward[i], b = backward[i - 1];
    forward[i] = f - reflection * b;
    backward[i] = b - reflection * f;
  }
}

// Levinson's update of the coefficients from one order to the next.
void Extend(double reflection, std::vector<double>* coefficients) {
  const std::vector<double> previous = *coefficients;
  for (size_t k = 0; k < previous.size(); ++k) {
    (*coefficients)[k] = previous[k] - reflection * previous[previous.size() - 1 - k];
  }
  coefficients->push_back(reflection);
}

// values[i] += sum_k phi_k values[i + k], from the last to the first; what lies beyond the last is
// `later`, or zero.
void RunBackwards(const Autoregression& noise,
                  std::span<const double> later,
                  std::span<double> values) {
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  const auto num_later = static_cast<std::ptrdiff_t>(later.size());
  const std::ptrdiff_t order = noise.order();
  const double* const phi = noise.coefficients.data();
  for (std::ptrdiff_t i = n - 1; i >= 0; --i) {
    double sum = values[i];
    const std::ptrdiff_t num_inside = std::min(order, n - 1 - i);
    for (std::ptrdiff_t k = 0; k < num_inside; ++k) sum += phi[k] * values[i + 1 + k];
    for (std::ptrdiff_t k = num_inside; k < order && i + 1 + k - n < num_later; ++k) {
      sum += phi[k] * later[i + 1 + k - n];
    }
    values[i] = sum;
  }
}

}  // namespace

Autoregression FitAutoregression(std::span<const std::vector<double>> pieces, int max_order) {
  std::vector<PredictionErrors> errors;
  double sum_of_squares = 0.0;
  double num_samples = 0.0;
  for (const auto& piece : pieces) {
    errors.push_back({piece, piece});
    num_samples += static_cast<double>(piece.size());
    for (const double e : piece) sum_of_squares += e * e;
  }
  Autoregression current;
  if (num_samples == 0.0) return current;
  current.innovation_variance = sum_of_squares / num_samples;

  Autoregression best = current;
  double best_criterion = std::numeric_limits<double>::infinity();
  for (int order = 0;; ++order) {
    const double criterion = num_samples * std::log(current.innovation_variance) + 2.0 * order;
    if (criterion < best_criterion) {
      best_criterion = criterion;
      best = current;
    }
    const bool is_hopeless = order >= best.order() + kPatience;
    if (order == max_order || is_hopeless || !(current.innovation_variance > 0.0)) break;
    const double reflection = Reflection(errors, order);
    for (auto& piece : errors) Advance(reflection, order, &piece);
    Extend(reflection, &current.coefficients);
    current.innovation_variance *= 1.0 - reflection * reflection;
  }
  return best;
}

Eigen::MatrixXd ColouredGram(const Autoregression& noise, Eigen::MatrixXd J) {
  // e = H w with H the recursion's impulse responses and w white, so J' Gamma J = s^2 (H'J)'(H'J).
  // Row i of H'J is what innovation i contributes to the sum: the recursion run backwards in time,
  // and on past the first sample, since innovations before it still echo in the piece.
  const auto n = static_cast<size_t>(J.rows());
  if (noise.order() == 0) return noise.innovation_variance * J.transpose() * J;
  for (auto column : J.colwise()) RunBackwards(noise, {}, {column.data(), n});
  // The echo of a stable recursion dies out; one longer than the piece itself is cut there.
  Eigen::MatrixXd before = Eigen::MatrixXd::Zero(J.rows(), J.cols());
  for (Eigen::Index k = 0; k < J.cols(); ++k) {
    RunBackwards(noise, {J.col(k).data(), n}, {before.col(k).data(), n});
  }
  return noise.innovation_variance * (J.transpose() * J + before.transpose() * before);
}

}  // namespace fathom
