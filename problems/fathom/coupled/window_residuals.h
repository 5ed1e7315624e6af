// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/fitted_channel.h"
#include "fathom/coupled/row_whitener.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/coupled_simulation.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A stretch of a log that is simulated from a start of its own.
struct CoupledWindow {
  const CoupledData* log = nullptr;
  const CoupledSegment* segment = nullptr;
  SampleWindow samples;  // of the velocities
  SampleWindow poses;    // within the same time
  CoupledState start;    // where the search begins: as measured
};

// The windows of the training data, or of all; about `length` [s] each.
std::vector<CoupledWindow> CoupledWindowsOf(std::span<const CoupledData> logs, double length);

// What is free at the start of a window, in this order: the velocities of the modelled DOFs, turns
// about the body's axes, and the position.
struct FreeStart {
  std::vector<int> rows;  // of the modelled DOFs
  std::array<bool, 3> turns = {};
  bool position = false;

  int size() const;
};
FreeStart FreeStartOf(std::span<const CoupledData> logs,
                      const std::vector<FittedChannel>& channels);

// A start moved by a step of what is free.
CoupledState Moved(const CoupledState& start, const FreeStart& free, const Eigen::VectorXd& step);

// How each channel is weighed.
struct ChannelWeight {
  RowWhitener whitener;
  double huber_k = 3.0;  // from how many standard deviations on a residual counts linearly
};

// Simulated less measured, in the order of the channels, each an unbroken run of samples.
struct WindowResiduals {
  struct Piece {
    std::size_t channel = 0;
    std::vector<double> time;

    // A row for each sample: the residual [unit of the channel], then its derivatives by the
    // entries and by the start, or none.
    RowMajorRows rows;
  };
  std::vector<Piece> pieces;
};

// What is in `residuals` is written over, its memory used again. False if the run diverges.
bool ResidualsOf(const CoupledWindow& window,
                 const CoupledModel& model,
                 const CoupledState& start,
                 std::span<const FreeEntry> entries,
                 const std::vector<FittedChannel>& channels,
                 const FreeStart& free,
                 bool with_derivatives,
                 WindowResiduals* residuals);

}  // namespace fathom
