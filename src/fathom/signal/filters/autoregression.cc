// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/autoregression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fathom {
namespace {

// So many orders without a better criterion end the search for one.
constexpr int kPatience = 10;

constexpr Eigen::Index kBlock = 512;  // rows filtered at once: they fit into the fastest cache

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

// P such that S' P S is what the filtered rows beyond the end of a piece add to the Gram matrix,
// S holding the last rows inside, the latest first. With the recursion as z_{i+1} = F z_i over such
// states, P = f f' + F' P F, where f' is the first row of F; summed up by doubling.
Eigen::MatrixXd EchoOf(const Autoregression& noise) {
  constexpr int kMostDoublings = 40;  // more samples than any log has
  const Eigen::Index order = noise.order();
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(order, order);
  if (order == 0) return F;
  F.row(0) = Eigen::RowVectorXd::Map(noise.coefficients.data(), order);
  F.diagonal(-1).setOnes();
  Eigen::MatrixXd P = F.row(0).transpose() * F.row(0);
  for (int i = 0; i < kMostDoublings; ++i) {
    const Eigen::MatrixXd before = P;
    P += F.transpose() * before * F;
    if (P == before) break;
    F = (F * F).eval();
  }
  return P;
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

ColouredGram::ColouredGram(Autoregression noise, Eigen::Index num_columns)
    : noise_(std::move(noise)),
      echo_(EchoOf(noise_)),
      gram_(Eigen::MatrixXd::Zero(num_columns, num_columns)),
      filtered_(Eigen::MatrixXd::Zero(noise_.order() + kBlock, num_columns)) {}

void ColouredGram::Add(const Eigen::Ref<const Eigen::MatrixXd>& rows) {
  for (Eigen::Index begin = 0; begin < rows.rows(); begin += kBlock) {
    AddBlock(rows.middleRows(begin, std::min(kBlock, rows.rows() - begin)));
  }
}

Eigen::MatrixXd ColouredGram::EndPiece() {
  const Eigen::MatrixXd last = filtered_.topRows(noise_.order()).colwise().reverse();
  const Eigen::MatrixXd gram =
      noise_.innovation_variance * (gram_ + last.transpose() * echo_ * last);
  gram_.setZero();
  filtered_.setZero();
  return gram;
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
