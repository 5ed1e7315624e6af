// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/local_polynomial.h"

#include <array>
#include <cstddef>

namespace fathom {

// The normal equations G a = b of a polynomial's coefficients, by Cholesky's factors L D L'.
class NormalEquations {
 public:
  using Coefficients = std::array<double, kHighestOrder + 1>;

  explicit NormalEquations(int order) : size_(order + 1) {}

  // Takes G from entry(k, l), which is asked for l <= k. False if a pivot is below the share
  // `smallest_pivot` of its diagonal: so much of the digits is lost.
  template <typename Entry>
  bool Factorize(const Entry& entry, double smallest_pivot) {
    for (int k = 0; k < size_; ++k) {
      Coefficients rest;
      for (int l = 0; l < k; ++l) {
        rest[l] = entry(k, l);
        for (int j = 0; j < l; ++j) rest[l] -= rest[j] * L_[l][j];
        L_[k][l] = rest[l] * inverse_D_[l];
      }
      const double diagonal = entry(k, k);
      double pivot = diagonal;
      for (int l = 0; l < k; ++l) pivot -= rest[l] * L_[k][l];
      if (!(pivot > smallest_pivot * diagonal)) return false;
      inverse_D_[k] = 1.0 / pivot;
    }
    return true;
  }

  // Turns b into a.
  void Solve(Coefficients* b) const {
    Coefficients& a = *b;
    for (int k = 0; k < size_; ++k) {
      for (int l = 0; l < k; ++l) a[k] -= L_[k][l] * a[l];
    }
    for (int k = size_ - 1; k >= 0; --k) {
      a[k] *= inverse_D_[k];
      for (int l = k + 1; l < size_; ++l) a[k] -= L_[l][k] * a[l];
    }
  }

 private:
  int size_;
  std::array<Coefficients, kHighestOrder + 1> L_;
  Coefficients inverse_D_;
};

}  // namespace fathom
