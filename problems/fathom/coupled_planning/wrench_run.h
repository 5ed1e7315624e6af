// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/autoregression.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// How a run will be measured and fitted.
struct WrenchMeasurement {
  double period = 0.1;               // of the stamps [s]
  std::array<double, 6> noise = {};  // at each, by Index(Dof) [m/s] or [rad/s]
  double window = 20.0;              // the fit begins its simulation anew after so long [s]

  // Of the noise over the stamps, with stationary variance 1; of order 0: white. The fit weighs by
  // it.
  std::array<Autoregression, 6> colour = {};
};

// What a model does under a wrench from t = 0 on, at rest and upright there. Nothing if the run
// diverges.
std::optional<std::vector<CoupledState>> WrenchMotion(const CoupledModel& model,
                                                      const CoupledCommand& command,
                                                      std::span<const double> stamps);

// The Fisher information about the entries of a model that the velocities of its DOFs hold,
// docs/plan.md (1): the sum over the windows of a fit, at each of whose starts the velocities are
// free, and the tilt where roll or pitch is modelled. A window that was computed once, from the
// same state under the same forces, is not computed again. Not for several threads at once.
class WrenchInformation {
 public:
  WrenchInformation(const CoupledModel& model,
                    std::vector<FreeEntry> entries,
                    const WrenchMeasurement& measurement);

  // Up to `duration` [s], from rest and upright. Nothing if the run diverges.
  std::optional<Eigen::MatrixXd> Of(const CoupledCommand& command, double duration);

 private:
  struct Window {
    bool is_finite = false;
    Eigen::MatrixXd information;
    CoupledState end;
  };
  const Window& WindowOf(const CoupledCommand& command,
                         const CoupledState& start,
                         double from,
                         double to);

  CoupledModel model_;
  std::vector<FreeEntry> entries_;
  WrenchMeasurement measurement_;
  std::map<std::vector<double>, Window> known_;  // by the times, the state and the forces
};

}  // namespace fathom
