// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/autoregression.h"

#include "fathom/signal/filters/noise_echo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fathom {
namespace {

// So many orders without a better criterion end the search for one.
constexpr int kPatience = 10;

constexpr Eigen::Index kBlock = 512;  // rows filtered at once: they fit into the fastest cache

// The echo behind a piece is followed in blocks until one adds less than this share, or for so
// many.
constexpr Eigen::Index kEchoBlock = 64;
constexpr int kMostEchoBlocks = 16;
constexpr double kSmallestEcho = 1e-15;

// Forward and backward prediction errors of one piece, as Burg's recursion carries them. At
// `order`, forward[i] belongs to sample i, backward[i] to sample i + order.
struct PredictionErrors {
  std::vector<double> forward;
  std::vector<double> backward;
};

// What the next reflection coefficient is made of.
struct ErrorProducts {
  double cross = 0.0, forward_power = 0.0, backward_power = 0.0;

  // The coefficient that minimises both prediction errors of the next order.
  double Reflection() const {
    const double power = forward_power + backward_power;
    return power > 0.0 ? 2.0 * cross / power : 0.0;
  }
};

// Takes the errors from `order` to the next one and adds up their products, in one go over them.
void Advance(double reflection, int order, PredictionErrors* errors, ErrorProducts* products) {
  auto& [forward, backward] = *errors;
  const size_t first = order + 1;
  ErrorProducts sums;
  double previous = 0.0;  // backward error one sample earlier; of none before the first
  for (size_t i = first; i < forward.size(); ++i) {
    const double f = forward[i], b = backward[i - first];
    const double advanced = f - reflection * b;
    if (i > first) {
      sums.cross += advanced * previous;
      sums.forward_power += advanced * advanced;
      sums.backward_power += previous * previous;
    }
    forward[i] = advanced;
    previous = backward[i - first] = b - reflection * f;
  }
  products->cross += sums.cross;
  products->forward_power += sums.forward_power;
  products->backward_power += sums.backward_power;
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

Autoregression FitAutoregression(std::vector<std::vector<double>> pieces, int max_order) {
  std::vector<PredictionErrors> errors;
  double sum_of_squares = 0.0;
  double num_samples = 0.0;
  ErrorProducts products;
  for (auto& piece : pieces) {
    num_samples += static_cast<double>(piece.size());
    for (const double e : piece) sum_of_squares += e * e;
    std::vector<double> backward = piece;
    errors.push_back({std::move(piece), std::move(backward)});
    Advance(0.0, -1, &errors.back(), &products);  // of order 0: the samples themselves
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
    const double reflection = products.Reflection();
    products = {};
    for (auto& piece : errors) Advance(reflection, order, &piece, &products);
    Extend(reflection, &current.coefficients);
    current.innovation_variance *= 1.0 - reflection * reflection;
  }
  return best;
}

Autoregression AutoregressionOf(std::span<const double> covariances) {
  Autoregression found;
  found.innovation_variance = covariances[0];
  for (std::size_t order = 0; order + 1 < covariances.size(); ++order) {
    double left = covariances[order + 1];
    for (std::size_t i = 0; i < order; ++i) {
      left -= found.coefficients[i] * covariances[order - i];
    }
    const double reflection = left / found.innovation_variance;
    Extend(reflection, &found.coefficients);
    found.innovation_variance *= 1.0 - reflection * reflection;
  }
  return found;
}

ColouredGram::ColouredGram(Autoregression noise, Eigen::Index num_columns)
    : noise_(std::move(noise)),
      gram_(Eigen::MatrixXd::Zero(num_columns, num_columns)),
      filtered_(Eigen::MatrixXd::Zero(noise_.order() + kBlock, num_columns)) {}

void ColouredGram::Add(const Eigen::Ref<const Eigen::MatrixXd>& rows) {
  for (Eigen::Index begin = 0; begin < rows.rows(); begin += kBlock) {
    AddBlock(rows.middleRows(begin, std::min(kBlock, rows.rows() - begin)));
  }
}

Eigen::MatrixXd ColouredGram::EndPiece() {
  FollowEcho();
  const Eigen::MatrixXd gram = noise_.innovation_variance * gram_;
  gram_.setZero();
  filtered_.setZero();
  return gram;
}

// Most echoes are over after some rows. What is left of a long one is summed up in closed form.
void ColouredGram::FollowEcho() {
  if (noise_.order() == 0) return;
  const Eigen::MatrixXd nothing = Eigen::MatrixXd::Zero(kEchoBlock, gram_.cols());
  for (int block = 0; block < kMostEchoBlocks; ++block) {
    const Eigen::VectorXd before = gram_.diagonal();
    AddBlock(nothing);
    const Eigen::VectorXd added = gram_.diagonal() - before;
    if ((added.array() <= kSmallestEcho * before.array()).all()) return;
  }
  if (echo_.size() == 0) echo_ = EchoOf(noise_.coefficients);
  const auto last = filtered_.topRows(noise_.order());
  gram_.noalias() += last.transpose() * echo_ * last;
}

// e = H w with H the recursion's impulse responses and w white, so J' Gamma J = s^2 (H'J)'(H'J).
// H'J is the recursion run backwards in time over the columns of J; but Gamma is the same in either
// direction of time, and so is the sum: it may run forwards.
void ColouredGram::AddBlock(const Eigen::Ref<const Eigen::MatrixXd>& rows) {
  const Eigen::Index order = noise_.order(), n = rows.rows();
  filtered_.middleRows(order, n) = rows;
  for (auto column : filtered_.colwise()) {
    for (double* z = column.data() + order; z != column.data() + order + n; ++z) {
      for (Eigen::Index k = order; k > 0; --k) *z += noise_.coefficients[k - 1] * z[-k];
    }
  }
  const auto block = filtered_.middleRows(order, n);
  gram_.noalias() += block.transpose() * block;
  filtered_.topRows(order) = filtered_.middleRows(n, order).eval();
}

}  // namespace fathom
