// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/fin_servo.h"
#include "fathom/simulate/coupled/lagged.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// What acts on a vehicle at an instant.
struct CoupledDrive {
  Vector6 tau = Vector6::Zero();   // forces of thrusters and wrench [N], [N m]
  std::vector<double> angles;      // of the fins [rad]
  std::vector<double> races;       // RaceThrust() of the fins, but for shafts [N]
  std::vector<double> turns = {};  // of the shafts [Hz]

  // By entry, what a unit of it changes tau by: of thrust gains, effects of the thrust, the angle,
  // offset and lag.
  std::vector<Vector6> tau_by_entry = {};
  // By entry and fin, what a unit of it changes the angle by: of the offset, lags and limited
  // rates. Empty where all fins follow at once.
  std::vector<std::vector<double>> angles_by_entry = {};
};

// What a command gives over time, with the gains, the angle, the offset, the lags and the limited
// rates of a model.
class CommandedDrive {
 public:
  // All must outlive this.
  CommandedDrive(const CoupledModel& model,
                 std::span<const FreeEntry> entries,
                 const CoupledCommand& command);

  // Stands at `t` [s], whatever it stood at before.
  void Begin(double t);

  // Moves on to the row that holds at `t`, which is not before that of the last call. Fins of a
  // limited rate whose time has come stand.
  void MoveTo(double t);

  // When the next row begins to hold, or a fin of a limited rate comes to stand [s]; infinity
  // behind the last.
  double NextChange() const;

  // At `t` [s], until then.
  const CoupledDrive& At(double t);

  // The longest step over which it can be taken for smooth [s].
  double LongestStep() const;

 private:
  double TimeOf(std::ptrdiff_t row) const;
  double NextRow() const;                       // when it begins to hold [s]
  double ArrivalOf(const FinServo& fin) const;  // when it comes to stand [s]; infinity: it stands
  std::ptrdiff_t RowAt(double t) const;         // -1 before the first
  void Next();                                  // the next row holds
  void Ask(double held);            // for the row, `held` s after the last began to hold
  void SlewTo(std::ptrdiff_t row);  // the fins of a limited rate, from the first row on
  void Arrive(double t);            // those whose time has come
  void Show(double since);          // `since` s after the row began to hold
  void ShowAnglesByEntry(double since);

  const CoupledModel& model_;
  std::span<const FreeEntry> entries_;
  const CoupledCommand& command_;
  double longest_lag_ = 0.0;  // [s]
  std::ptrdiff_t row_ = -1;   // that holds; -1: none yet
  Lagged<Vector6> tau_ = {Vector6::Zero(), Vector6::Zero(), Vector6::Zero()};
  std::vector<Lagged<Vector6>> pushed_;  // by entry: AskedForceBy()
  std::vector<FinServo> fins_;
  bool has_limited_fin_ = false;
  CoupledDrive drive_;
};

}  // namespace fathom
