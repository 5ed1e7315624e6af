// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/entry_prior.h"
#include "fathom/coupled/fitted_channel.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/coupled/window_residuals.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <cstddef>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace fathom {

// What a search over windows needs to know, and does not change.
struct WindowProblem {
  std::vector<CoupledWindow> windows;
  std::vector<FreeEntry> entries;
  std::vector<FittedChannel> channels;
  FreeStart free;
  RigidBody body;
  std::vector<EntryPrior> priors;
};

// A point of the search.
struct WindowPoint {
  CoupledModel model;
  std::vector<CoupledState> starts;  // of each window
};

// The residuals of the window `w`. False if the run diverges.
bool ResidualsIn(const WindowProblem& problem,
                 const WindowPoint& point,
                 std::size_t w,
                 bool with_derivatives,
                 WindowResiduals* residuals);

// Those of all windows. False if a run diverges.
bool AllResiduals(const WindowProblem& problem,
                  const WindowPoint& point,
                  std::vector<WindowResiduals>* residuals);

// The cost of the bounds and of the priors.
PhysicalBarrier BarrierIn(const WindowProblem& problem, const CoupledModel& model);

// What the priors add to the normal equations of the entries.
Eigen::MatrixXd OfPriors(const WindowProblem& problem, const CoupledModel& model);

// Whitens the rows of a piece. Those beyond the channel's huber_k weigh less. What the residuals
// cost.
double WeighRows(const ChannelWeight& weight, WindowResiduals::Piece* piece);

// Solves a start's normal equations `ss`, with a little added, so that what it leaves no trace of
// stays where it is. `damping`: a share of the diagonal that is added as well.
Eigen::LLT<Eigen::MatrixXd> StartSolver(const Eigen::MatrixXd& ss, double damping);

}  // namespace fathom
