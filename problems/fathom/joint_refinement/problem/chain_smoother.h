// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/motion/linear_segment.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Moments of one coordinate's states (n, dn/dt) over all steps of one duration.
struct StepMoments {
  Eigen::Matrix2d before = Eigen::Matrix2d::Zero();  // sum of E s_k s_k'
  Eigen::Matrix2d across = Eigen::Matrix2d::Zero();  // sum of E s_k+1 s_k'
  Eigen::Matrix2d after = Eigen::Matrix2d::Zero();   // sum of E s_k+1 s_k+1'
  double count = 0.0;
};

// What a segment's deviations turn out to be, given the data, one coordinate's state s = (n, dn/dt)
// at a time.
struct SegmentMoments {
  std::array<std::vector<StepMoments>, 6> steps;  // [coordinate][duration]
  std::array<Eigen::Matrix2d, 6> first;           // E s_0 s_0'
};

// The linearised problem of one segment in the order that makes it cheap: the deviations of its
// frames, which form a chain, are eliminated one after the other, and what is left concerns the
// globals only. Time and memory are linear in the frames. docs/joint_refinement.md (8) to (10)
//
// A frame's state is (n, dn/dt) of each of the six coordinates; a coordinate without a process
// stays on its mean.
class ChainSmoother {
 public:
  using State = Eigen::Matrix<double, 12, 1>;
  using Square = Eigen::Matrix<double, 12, 12>;
  using Border = Eigen::Matrix<double, 12, Eigen::Dynamic, Eigen::ColMajor, 12, kNumColumns>;

  // `excited`: index of the excited coordinate, which starts on its mean. `columns`: those of the
  // globals that are not held, rising. `segment` must outlive this object.
  ChainSmoother(const LinearSegment& segment,
                const ProcessSet& processes,
                int excited,
                const std::vector<int>& columns);

  // False if the deviations cannot be eliminated; the rest then means nothing.
  bool is_positive_definite() const { return is_positive_definite_; }

  // After elimination, 1/2 g' H g + g' b + constant over `columns`, without any prior on them.
  const Eigen::MatrixXd& H() const { return H_; }
  const Eigen::VectorXd& b() const { return b_; }
  double constant() const { return constant_; }

  // log det of what was eliminated, less that of the processes' prior.
  double log_determinant() const { return log_determinant_; }

  int num_eliminated() const { return num_eliminated_; }  // unknowns

  // The deviations that go with a change `g` of the columns.
  std::vector<State> Deviations(const Eigen::VectorXd& g) const;

  // Calls `visit` for each frame, the last one first, with what is left in doubt of its deviation:
  // P, its covariance where the columns are known, and G, how it moves with them.
  void ForEachFrame(
      const std::function<void(size_t frame, const Square& P, const Border& G)>& visit) const;

  // Moments where the columns have the mean `g` and covariance `covariance`.
  SegmentMoments Moments(const Eigen::VectorXd& g, const Eigen::MatrixXd& covariance) const;

 private:
  struct Eliminated {
    // Long segments have hundreds of megabytes of these: they are not cleared before they are
    // filled.
    Eliminated() {}

    Square S_inverse;
    State y;  // S^-1 b
  };

  // Step k's C: a block of each coordinate by its next state.
  using Coupling = std::array<Eigen::Matrix2d, 6>;

  struct Step;       // to the next frame, by duration
  struct Equations;  // of one frame's state

  // The parts of the elimination, in the constructor's order.
  std::vector<Step> LayOutSteps(const std::array<SecondOrderProcess, 6>& process);
  Equations BeforeFirst(const std::array<SecondOrderProcess, 6>& process, int excited);
  void AddFrame(const LinearFrame& frame,
                double weight,
                const std::vector<int>& columns,
                const Step* step,  // null behind the last frame
                Equations* equations) const;
  bool Eliminate(const Equations& equations, size_t k, Border* W);  // false: not positive definite
  void LeaveToNext(size_t k, const Step& step, const Border& W, Equations* left);

  // C X for frame k, which is not the last; only rows of coordinates with a process.
  template <typename Matrix>
  Matrix Coupled(size_t k, const Matrix& X) const;

  auto V(size_t k) const {  // S^-1 B
    return V_.middleCols(static_cast<Eigen::Index>(k) * num_columns_, num_columns_);
  }

  const LinearSegment& segment_;
  Eigen::Index num_columns_;
  std::array<bool, 6> is_present_;
  std::vector<Coupling> couplings_;  // by duration
  std::vector<Eliminated> eliminated_;
  Eigen::Matrix<double, 12, Eigen::Dynamic> V_;
  Eigen::MatrixXd H_;
  Eigen::VectorXd b_;
  double constant_ = 0.0;
  double log_determinant_ = 0.0;
  int num_eliminated_ = 0;
  bool is_positive_definite_ = true;
};

}  // namespace fathom
