// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_limits.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <cstddef>
#include <vector>

namespace fathom {

// LimitStamps() of a command, the coast behind it along.
std::vector<double> WrenchLimitStamps(double hold, double duration);

// Whether models keep the limits under one command after another, for a search that changes little
// from one to the next: runs begin where a command leaves the last one that all kept, and end with
// the piece that breaks a limit. Not for several threads at once.
class KeptWrench {
 public:
  // `duration`: of the commands [s]. The models must outlive this.
  KeptWrench(const std::vector<CoupledModel>& models, const CoupledLimits& limits, double duration);

  bool KeptByFirst(const CoupledCommand& command);
  bool KeptByAll(const CoupledCommand& command);

 private:
  struct Piece {
    double from = 0.0;
    std::vector<double> stamps;  // the last one is its end
  };
  using Ends = std::vector<CoupledState>;  // of a model's pieces

  // The pieces that the command shares with the last one that all kept.
  std::size_t NumShared(const CoupledCommand& command) const;
  bool Keeps(std::size_t model, const CoupledInputs& inputs, std::size_t num_shared, Ends* ends);

  const std::vector<CoupledModel>& models_;
  CoupledLimits limits_;
  std::vector<Piece> pieces_;
  CoupledCommand known_;          // that all kept
  std::vector<Ends> known_ends_;  // of each model under it
  std::size_t broke_last_ = 0;    // the model to try first
};

}  // namespace fathom
