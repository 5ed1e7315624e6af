// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/window_motion.h"

#include "fathom/coupled/window_residuals.h"
#include "fathom/coupled_refinement/deviated_pose.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>

namespace fathom {
namespace {

bool IsModelledIn(const MotionStructure& structure, int row) {
  return std::ranges::any_of(structure.dofs, [&](Dof dof) { return Index(dof) == row; });
}

// Everything about a start may move.
FreeStart WholeStart(const std::vector<Dof>& dofs) {
  FreeStart free;
  for (const Dof dof : dofs) free.rows.push_back(Index(dof));
  free.turns = {true, true, true};
  free.position = true;
  return free;
}

}  // namespace

std::vector<int> TrimRows(const MotionStructure& structure) {
  std::vector<int> rows;
  for (const Dof dof : {Dof::kRoll, Dof::kPitch}) {
    if (!IsModelledIn(structure, Index(dof))) rows.push_back(Index(dof));
  }
  return rows;
}

CoupledModel FilmUnknowns::Model(const MotionStructure& structure) const {
  CoupledModel with = model;
  for (std::size_t i = 0; i < structure.entries.size(); ++i) {
    SetValue(structure.entries[i], shared[i], &with);
  }
  return with;
}

FilmUnknowns FilmUnknownsAt(const CoupledFilm& film, const CoupledModel& model) {
  FilmUnknowns unknowns;
  unknowns.model = model;
  for (const FreeEntry& entry : film.structure.entries) {
    unknowns.shared.push_back(ValueIn(model, entry));
  }
  unknowns.shared.resize(unknowns.shared.size() + TrimRows(film.structure).size(), 0.0);
  for (std::size_t w = 0; w < film.windows.size(); ++w) {
    FilmWindowUnknowns& own = unknowns.windows.emplace_back();
    own.start.assign(static_cast<std::size_t>(WindowMotion(film, w).num_start()), 0.0);
    own.deviation.assign(film.windows[w].time.size(), {});
    own.rate.assign(film.windows[w].time.size(), {});
  }
  return unknowns;
}

WindowMotion::WindowMotion(const CoupledFilm& film, std::size_t window)
    : film_(film), window_(window) {
  const auto num_entries = static_cast<Eigen::Index>(film.structure.entries.size());
  const auto num_dofs = static_cast<Eigen::Index>(film.structure.dofs.size());
  const Eigen::Index first_turn = num_entries + num_dofs;
  for (Eigen::Index i = 0; i < num_entries; ++i) source_.push_back(i);
  for (const int row : TrimRows(film.structure)) {
    trim_.push_back(row - 3);
    source_.push_back(first_turn + row - 3);
  }
  num_shared_ = static_cast<int>(source_.size());
  for (Eigen::Index i = 0; i < num_dofs; ++i) source_.push_back(num_entries + i);
  for (int axis = 0; axis < 3; ++axis) {
    if (!IsModelledIn(film.structure, axis + 3)) continue;
    turns_.push_back(axis);
    source_.push_back(first_turn + axis);
  }
  num_start_ = static_cast<int>(source_.size()) + 3 - num_shared_;
}

bool WindowMotion::Update(const FilmUnknowns& unknowns, bool with_derivatives) {
  const FilmWindow& window = film_.windows[window_];
  const std::vector<double>& own = unknowns.windows[window_].start;
  const std::size_t num_dofs = film_.structure.dofs.size();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < trim_.size(); ++i) {
    turn[trim_[i]] = unknowns.shared[film_.structure.entries.size() + i];
  }
  for (std::size_t i = 0; i < turns_.size(); ++i) turn[turns_[i]] = own[num_dofs + i];
  Eigen::VectorXd step(static_cast<Eigen::Index>(num_dofs) + 6);
  step << Eigen::Map<const Eigen::VectorXd>(own.data(), static_cast<Eigen::Index>(num_dofs)), turn,
      Eigen::Map<const Eigen::Vector3d>(own.data() + own.size() - 3);
  const CoupledState start = Moved(window.start, WholeStart(film_.structure.dofs), step);
  const CoupledModel model = unknowns.Model(film_.structure);
  const CoupledStamps stamps = {window.time.front(), {}, window.time};
  CoupledOutputs outputs;
  const bool runs =
      with_derivatives
          ? RunCoupledWithSensitivities(
                model, film_.structure.entries, *window.inputs, start, stamps, &outputs)
          : RunCoupled(model, *window.inputs, start, stamps, &outputs);
  if (!runs) return false;
  const std::size_t n = window.time.size();
  poses_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    poses_[k] = {Eigen::Quaterniond(outputs.pose[k].attitude).normalized(),
                 outputs.pose[k].position};
  }
  derivatives_.clear();
  if (!with_derivatives) return true;
  const Eigen::Matrix3d by_turn = TurnJacobian(turn);
  for (std::size_t k = 0; k < n; ++k) {
    Eigen::Matrix<double, 6, Eigen::Dynamic> simulated =
        outputs.pose_sensitivity.middleRows<6>(6 * static_cast<Eigen::Index>(k));
    simulated.rightCols<3>() = (simulated.rightCols<3>() * by_turn).eval();
    Derivatives& D = derivatives_.emplace_back(Derivatives::Zero(6, num_shared_ + num_start_));
    const auto num_simulated = static_cast<Eigen::Index>(source_.size());
    D.topLeftCorner(3, num_simulated) = simulated.bottomRows<3>()(Eigen::all, source_);
    D.bottomLeftCorner(3, num_simulated) = simulated.topRows<3>()(Eigen::all, source_);
    D.topRightCorner<3, 3>().setIdentity();
  }
  return true;
}

}  // namespace fathom
