// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_drive.h"
#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/tangent_step.h"
#include "fathom/vehicle/coupled/coupled_effects.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A state, or its rate.
struct CoupledFlow {
  Vector6 nu;
  Eigen::Vector4d attitude;
  Eigen::Vector3d position;
};

// docs/coupled.md (1) as a rate of the state, and its derivative.
class CoupledRate {
 public:
  // All must outlive this. `log`: of the run, by whose name the model may know an offset.
  CoupledRate(const CoupledModel& model,
              std::span<const FreeEntry> entries,
              const CoupledCommand& command,
              const std::string& log = {});

  bool IsUsable() const { return is_usable_; }

  // Rate at a state. The rates of DOFs that are not modelled are 0.
  CoupledFlow At(const CoupledFlow& state, const CoupledDrive& drive) const;

  // How tangents move at a state.
  TangentLaw LawAt(const CoupledFlow& state, const CoupledDrive& drive) const;

  // What a unit of each entry does to the forces: a column for each. `rate`: At() the same.
  // Of an entry that acts along one row alone, the others are not written: RowOfEntry().
  void ForcesOfEntries(const CoupledFlow& state,
                       const CoupledFlow& rate,
                       const CoupledDrive& drive,
                       Eigen::Matrix<double, 6, Eigen::Dynamic>* forces) const;

  // The one row that an entry acts along; -1 of an entry that may act along all.
  Eigen::Index RowOfEntry(std::size_t k) const { return rows_[k]; }

  // Of M, 0 where not modelled.
  const Matrix6& inverse_inertia() const { return inverse_; }

  // The quickest rate of a small difference [1/s], at the state of a law: a bound that no unit
  // changes.
  double Quickest(const CoupledFlow& state, const Matrix6& force_by_nu) const;

  // Of the right-hand side by nu.
  Matrix6 ForceJacobian(const Vector6& nu, const CoupledDrive& drive) const;

 private:
  // A fin of the model.
  struct ModelFin {
    std::size_t at = 0;  // in the commands
    double force = 0.0, race = 0.0, neutral = 0.0;
    std::optional<double> stuck = {};
    double stall = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> shafts = {};  // in whose race it stands
  };

  // A shaft of the model.
  struct ModelShaft {
    std::size_t at = 0;  // in the commands
    double gain = 1.0;
  };

  // k T of a fin's race, and its derivative.
  struct Race {
    double value = 0.0;
    Vector6 by_nu = Vector6::Zero();
  };
  // What the effects of the water resist with, along their DOFs.
  struct ModelEffect {
    const Effect* effect = nullptr;
    Eigen::Index row = 0;
    double value = 0.0;
  };
  ModelEffect EffectOf(const FreeEntry& entry) const;
  EffectResistance ResistanceAt(const ModelEffect& effect, const Vector6& nu) const;

  // What an entry does by the angles of fins.
  Vector6 ForceByAngles(std::size_t entry, const Vector6& nu, const CoupledDrive& drive) const;

  Race RaceOf(const ModelFin& fin, const Vector6& nu, const CoupledDrive& drive) const;

  FinLoad LoadOf(const ModelFin& fin, const Vector6& nu, const CoupledDrive& drive) const;

  const CoupledModel& model_;
  std::span<const FreeEntry> entries_;
  const CoupledCommand& command_;
  std::vector<ModelFin> fins_;
  std::vector<ModelShaft> shafts_;
  std::vector<ModelEffect> effects_;
  std::vector<std::optional<std::size_t>> shaft_of_entry_;  // whose gain an entry is
  std::vector<std::size_t> fin_of_entry_;  // in fins_, of entries that belong to one
  bool has_lift_ = false;
  Vector6 offset_;                     // of this run
  std::vector<bool> is_of_other_run_;  // of the entries
  Matrix6 inverse_ = Matrix6::Zero();  // of the modelled part of M
  Vector6 scale_ = Vector6::Zero();    // 1 / sqrt(M_ii), 0 where not modelled
  double restoring_rate_ = 0.0;        // [1/s]
  std::vector<Eigen::Index> rows_;     // RowOfEntry()
  bool is_usable_ = false;
};

}  // namespace fathom
