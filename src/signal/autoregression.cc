// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/autoregression.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fathom {
namespace {

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
    if (order == max_order || !(current.innovation_variance > 0.0)) break;
    const double reflection = Reflection(errors, order);
    for (auto& piece : errors) Advance(reflection, order, &piece);
    Extend(reflection, &current.coefficients);
    current.innovation_variance *= 1.0 - reflection * reflection;
  }
  return best;
}

Eigen::MatrixXd ColouredGram(const Autoregression& noise, const Eigen::MatrixXd& J) {
  // e = H w with H the recursion's impulse responses and w white, so J' Gamma J = s^2 (H'J)'(H'J).
  // Row i of H'J is what innovation i contributes to the sum: the recursion run backwards in time,
  // and on past the first sample, since innovations before it still echo in the piece.
  using RowVector = Eigen::RowVectorXd;
  const Eigen::Index columns = J.cols();
  const int order = noise.order();
  std::vector<RowVector> later(order, RowVector::Zero(columns));  // rows i+1 ... i+p, a ring
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns, columns);
  int newest = 0;
  double largest = 0.0;
  int num_small = 0;
  RowVector row(columns);
  for (Eigen::Index i = J.rows() - 1; i >= -100 * J.rows(); --i) {
    if (i >= 0) {
      row = J.row(i);
    } else {
      row.setZero();
    }
    for (int k = 0; k < order; ++k) {
      row += noise.coefficients[k] * later[(newest + k) % order];
    }
    gram.noalias() += row.transpose() * row;
    if (order > 0) {
      newest = (newest + order - 1) % order;
      later[newest] = row;
    }
    const double size = row.cwiseAbs().maxCoeff();
    largest = std::max(largest, size);
    num_small = size <= 1e-6 * largest ? num_small + 1 : 0;
    if (i <= 0 && num_small > order) break;
  }
  return noise.innovation_variance * gram;
}

}  // namespace fathom
