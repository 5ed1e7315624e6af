// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <string>
#include <vector>

namespace fathom {

// A cost some of whose unknowns must not fall below 0, with a search that knows nothing of bounds.
class BoundedSearch {
 public:
  virtual ~BoundedSearch() = default;

  struct Optimum {
    bool converged = false;
    double cost = std::numeric_limits<double>::infinity();
    std::string message;
  };

  // The least cost with these unknowns held where they are and all others free, searched from the
  // present point, which moves there.
  virtual Optimum Solve(const std::vector<int>& held) = 0;

  // Of a bounded unknown, at the present point.
  virtual double Value(int unknown) const = 0;
  virtual void SetToZero(int unknown) = 0;

  // The present point with all unknowns.
  virtual std::vector<double> Point() const = 0;
  virtual void GoTo(const std::vector<double>& point) = 0;
};

struct BoundedOptimum {
  bool converged = false;
  double cost = std::numeric_limits<double>::infinity();
  std::string message;
  std::vector<int> held;  // unknowns on their bound, rising
};

// The least cost with all of `bounded` at least 0, from the present point, which moves there: a
// primal active set. What comes out negative is held at 0. From then on every point is feasible; an
// unknown is let go, or exchanged for another, where that lowers the cost by more than
// `resolution` (a share of the cost), so that no set comes back and the search ends.
//
// Whether an unknown presses on its bound is seen by letting it go: its optimum then lies below 0.
// The slope of the cost at the bound does not tell, as soon as it is smaller than what the other
// unknowns, which are never searched to the last digit, leave of theirs. (It sent an earlier
// version round in circles.)
//
// Where the cost is convex, at most one exchange is needed for each unknown let go, and the
// conditions of Karush, Kuhn and Tucker hold at the end; where it is not, they may be out of reach,
// which is said.
BoundedOptimum SearchActiveSet(const std::vector<int>& bounded,
                               double resolution,
                               BoundedSearch* search);

}  // namespace fathom
