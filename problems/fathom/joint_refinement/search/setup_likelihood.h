// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/joint_state.h"
#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The priors at given unknowns, as in LinearJoint.
using PriorsAt = std::function<std::vector<GlobalsPrior>(const JointUnknowns&)>;

// The same priors with the size scale and the mount held where they are.
std::vector<GlobalsPrior> WithSetupHeld(std::vector<GlobalsPrior> priors);

// The processes of a world whose lengths are `factor` times as long: what is a length in them, or
// is counted in lengths, along with it.
ProcessSet Scaled(const ProcessSet& processes, int excited, double factor);

// The restricted likelihood of the setup (the markers' size and the camera's mount) under given
// processes; docs/joint_refinement.md (14), (15).
class SetupLikelihood {
 public:
  // About `unknowns`, their mode. `priors_at` must outlive this object, as must `data`.
  SetupLikelihood(const PriorsAt& priors_at,
                  const ProcessSet& processes,
                  const JointUnknowns& unknowns,
                  JointData* data);

  struct Value {
    bool is_usable = false;
    double value = 0.0;
    JointUnknowns unknowns;  // at their mode
    ProcessSet processes;
  };

  // With the setup moved by `change`, kNumColumns numbers of which the others are 0. The mode over
  // everything else is searched by Gauss and Newton from where the linear problem expects it.
  Value At(const Eigen::VectorXd& change) const;

 private:
  // Searches the mode of result->unknowns with the setup held. False if there is none.
  bool FindMode(std::vector<LinearSegment> linear, Value* result) const;

  const PriorsAt& priors_at_;
  const ProcessSet processes_;
  const JointUnknowns centre_;
  JointData* const data_;
  double size_ = 1.0;
  double num_rows_ = 0.0;
  std::vector<LinearSegment> linear_;
  bool is_usable_ = false;
};

}  // namespace fathom
