// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/pattern.h"

#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fathom {
namespace {

constexpr double kLeastShare = 0.02;      // of a DOF's thrust, for a thruster to be seen in it
constexpr double kLeastEigenvalue = 1.5;  // of a correlation of 0.5 between two parameters
constexpr double kLeastPartInDirection = 0.3;

bool IsOfKind(const DiveSeries& series, FreeEntry::Kind kind) {
  return series.entry && series.entry->kind == kind;
}

bool IsDamping(const DiveSeries& series) {
  if (IsOfKind(series, FreeEntry::Kind::kLinearDamping) ||
      IsOfKind(series, FreeEntry::Kind::kQuadraticDamping)) {
    return true;
  }
  return series.parameter == kQuadraticDamping || series.parameter == kLinearDamping;
}

std::vector<Dof> DofsOf(std::span<const DiveSeries> series) {
  std::vector<Dof> dofs;
  for (const DiveSeries& one : series) {
    if (one.IsOfActuator()) continue;
    if (dofs.empty() || dofs.back() != one.dof) dofs.push_back(one.dof);
  }
  return dofs;
}

Pattern Empty(const std::string& cause, std::span<const DiveSeries> series) {
  const Eigen::Index size = static_cast<Eigen::Index>(series.size());
  Pattern pattern;
  pattern.cause = cause;
  pattern.directions = Eigen::MatrixXd::Zero(size, 0);
  pattern.share = Eigen::VectorXd::Zero(size);
  return pattern;
}

void AddDirection(const Eigen::VectorXd& direction, Pattern* pattern) {
  pattern->directions.conservativeResize(Eigen::NoChange, pattern->directions.cols() + 1);
  pattern->directions.rightCols(1) = direction;
}

void FreeSize(Eigen::Index s, Pattern* pattern) {
  AddDirection(Eigen::VectorXd::Unit(pattern->share.size(), s), pattern);
}

void AddPayload(std::span<const DiveSeries> series, std::vector<Pattern>* patterns) {
  Pattern mass = Empty("payload", series);
  Eigen::VectorXd same_mass = Eigen::VectorXd::Zero(mass.share.size());
  std::vector<Eigen::Index> moments;
  for (Eigen::Index s = 0; s < same_mass.size(); ++s) {
    const bool couples = IsOfKind(series[s], FreeEntry::Kind::kInertia) &&
                         series[s].entry->row != series[s].entry->column;
    if (series[s].parameter != kInertia && !couples) continue;
    if (IsAngular(series[s].dof) || couples) {
      moments.push_back(s);
    } else {
      same_mass(s) = 1.0 / series[s].scale;
    }
  }
  if (!same_mass.isZero()) {
    AddDirection(same_mass, &mass);
    patterns->push_back(mass);
  }
  if (moments.empty()) return;
  for (const Eigen::Index s : moments) FreeSize(s, &mass);
  patterns->push_back(mass);
}

// One factor, or free sizes, in each choice of DOFs.
void AddFouling(std::span<const DiveSeries> series, std::vector<Pattern>* patterns) {
  const std::vector<Dof> dofs = DofsOf(series);
  for (unsigned choice = 1; choice < (1u << dofs.size()); ++choice) {
    Pattern factor = Empty("fouling", series);
    Pattern free = factor;
    for (Eigen::Index s = 0; s < factor.share.size(); ++s) {
      const auto dof = std::find(dofs.begin(), dofs.end(), series[s].dof) - dofs.begin();
      if (!IsDamping(series[s]) || (choice >> dof & 1u) == 0) continue;
      factor.share(s) = 1.0;
      FreeSize(s, &free);
    }
    for (Pattern pattern : {factor, free}) {
      if (!pattern.HasFactor() && pattern.directions.cols() == 0) continue;
      pattern.sign = PatternSign::kGrows;
      patterns->push_back(pattern);
      pattern.cause = "cleaning";
      pattern.sign = PatternSign::kShrinks;
      patterns->push_back(pattern);
    }
  }
}

// What a thruster adds beside another of its kind: its coefficient, or the largest thrust of its
// table. All are alike where neither is known.
double StrengthOf(const Thruster& thruster, const Vehicle& vehicle) {
  if (const ThrustTable* table = TableOf(thruster, vehicle)) return table->thrust.back().back();
  return thruster.forward_coefficient > 0.0 ? thruster.forward_coefficient : 1.0;
}

// Of a thruster, by series and dive; empty where no dive knows it.
Eigen::MatrixXd ShareOfDives(std::span<const DiveSeries> series,
                             std::span<const DiveEstimate> estimates,
                             int num_dives,
                             const std::string& thruster) {
  Eigen::MatrixXd shares = Eigen::MatrixXd::Constant(std::ssize(series), num_dives, std::nan(""));
  for (Eigen::Index s = 0; s < shares.rows(); ++s) {
    for (const int i : series[s].estimate) {
      const auto& known = estimates[i].thruster_shares;
      if (const auto share = known.find(thruster); share != known.end()) {
        shares(s, estimates[i].dive) = share->second;
      }
    }
  }
  return shares.array().isNaN().all() ? Eigen::MatrixXd() : shares;
}

// Of the gains of thrusters that a coupled model holds: each alone.
void AddGains(std::span<const DiveSeries> series, std::vector<Pattern>* patterns) {
  for (Eigen::Index s = 0; s < std::ssize(series); ++s) {
    if (!IsOfKind(series[s], FreeEntry::Kind::kThrustGain)) continue;
    Pattern pattern = Empty("thruster(" + series[s].entry->actuator + ")", series);
    FreeSize(s, &pattern);
    patterns->push_back(pattern);
  }
}

bool HasGainOf(const std::string& thruster, std::span<const DiveSeries> series) {
  return std::ranges::any_of(series, [&](const DiveSeries& one) {
    return IsOfKind(one, FreeEntry::Kind::kThrustGain) && one.entry->actuator == thruster;
  });
}

void AddThrusters(std::span<const DiveSeries> series,
                  std::span<const DiveEstimate> estimates,
                  int num_dives,
                  const Vehicle& vehicle,
                  std::vector<Pattern>* patterns) {
  const auto allocation = AllocationMatrix(vehicle.thrusters);
  Eigen::VectorXd coefficients(allocation.cols());
  for (Eigen::Index k = 0; k < coefficients.size(); ++k) {
    coefficients(k) = StrengthOf(vehicle.thrusters[k], vehicle);
  }
  const Eigen::MatrixXd capability = allocation.cwiseAbs() * coefficients.asDiagonal();
  for (Eigen::Index k = 0; k < coefficients.size(); ++k) {
    if (HasGainOf(vehicle.thrusters[k].name, series)) continue;
    Pattern pattern = Empty("thruster(" + vehicle.thrusters[k].name + ")", series);
    for (Eigen::Index s = 0; s < pattern.share.size(); ++s) {
      if (series[s].IsOfActuator()) continue;
      const int row = Index(series[s].dof);
      const double share = capability(row, k) / std::max(capability.row(row).sum(), 1e-300);
      if (share >= kLeastShare) pattern.share(s) = share;
    }
    pattern.share_of_dive = ShareOfDives(series, estimates, num_dives, vehicle.thrusters[k].name);
    if (pattern.HasFactor()) patterns->push_back(pattern);
  }
}

void AddThrust(std::span<const DiveSeries> series,
               std::span<const DiveEstimate> estimates,
               int num_dives,
               const std::optional<Vehicle>& vehicle,
               std::vector<Pattern>* patterns) {
  if (vehicle && !vehicle->thrusters.empty()) {
    AddThrusters(series, estimates, num_dives, *vehicle, patterns);
  } else {
    for (const Dof dof : DofsOf(series)) {
      Pattern pattern = Empty("thrust(" + std::string(Name(dof)) + ")", series);
      for (Eigen::Index s = 0; s < pattern.share.size(); ++s) {
        if (series[s].dof == dof && !series[s].IsOfActuator()) pattern.share(s) = 1.0;
      }
      patterns->push_back(pattern);
    }
  }
  AddGains(series, patterns);
  Pattern battery = Empty("battery", series);
  for (Eigen::Index s = 0; s < battery.share.size(); ++s) {
    battery.share(s) = series[s].IsOfActuator() ? 0.0 : 1.0;
  }
  patterns->push_back(battery);
}

void AddBallast(std::span<const DiveSeries> series, std::vector<Pattern>* patterns) {
  Pattern all = Empty("ballast", series);
  for (Eigen::Index s = 0; s < all.share.size(); ++s) {
    if (series[s].parameter != kBuoyancy) continue;
    Pattern one = Empty("ballast", series);
    FreeSize(s, &one);
    FreeSize(s, &all);
    patterns->push_back(one);
  }
  if (all.directions.cols() > 1) patterns->push_back(all);
}

// Along the direction that the dives of a DOF know least.
void AddExcitation(std::span<const DiveSeries> series,
                   const Eigen::MatrixXd& mean_correlation,
                   std::vector<Pattern>* patterns) {
  for (const Dof dof : DofsOf(series)) {
    std::vector<Eigen::Index> rows;
    for (Eigen::Index s = 0; s < mean_correlation.rows(); ++s) {
      if (series[s].dof == dof && !series[s].IsOfActuator()) rows.push_back(s);
    }
    const Eigen::MatrixXd correlation = mean_correlation(rows, rows);
    const SymmetricEigen eigen = EigenOf(correlation);
    if (eigen.values.tail(1)(0) < kLeastEigenvalue) continue;
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(mean_correlation.rows());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double part = eigen.vectors(i, rows.size() - 1);
      if (std::abs(part) >= kLeastPartInDirection) direction(rows[i]) = part;
    }
    Pattern pattern = Empty("excitation", series);
    AddDirection(direction, &pattern);
    patterns->push_back(pattern);
  }
}

}  // namespace

std::vector<Pattern> PatternsOf(std::span<const DiveSeries> series,
                                std::span<const DiveEstimate> estimates,
                                int num_dives,
                                const Eigen::MatrixXd& mean_correlation,
                                const std::optional<Vehicle>& vehicle) {
  std::vector<Pattern> patterns;
  AddPayload(series, &patterns);
  AddFouling(series, &patterns);
  AddThrust(series, estimates, num_dives, vehicle, &patterns);
  AddBallast(series, &patterns);
  AddExcitation(series, mean_correlation, &patterns);
  return patterns;
}

std::vector<Pattern> PatternsAt(std::span<const Pattern> patterns, const Column& column) {
  std::vector<Pattern> at(patterns.begin(), patterns.end());
  for (Pattern& pattern : at) {
    for (Eigen::Index s = 0; s < pattern.share_of_dive.rows(); ++s) {
      double sum = 0.0;
      int count = 0;
      const int first = column.kind == ChangeKind::kStep ? column.at : 0;
      for (Eigen::Index dive = first; dive < pattern.share_of_dive.cols(); ++dive) {
        const double share = pattern.share_of_dive(s, dive);
        if (std::isnan(share)) continue;
        sum += share;
        ++count;
      }
      if (count == 0) continue;
      const double mean = sum / count;
      pattern.share(s) = std::abs(mean) >= kLeastShare ? mean : 0.0;
    }
  }
  return at;
}

Eigen::MatrixXd MeanCorrelation(std::span<const DiveBlock> blocks, std::size_t num_series) {
  const Eigen::Index size = static_cast<Eigen::Index>(num_series);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd count = Eigen::MatrixXd::Zero(size, size);
  for (const DiveBlock& block : blocks) {
    const Eigen::VectorXd scale = block.covariance.diagonal().cwiseSqrt();
    for (Eigen::Index i = 0; i < scale.size(); ++i) {
      for (Eigen::Index j = 0; j < scale.size(); ++j) {
        sum(block.series[i], block.series[j]) += block.covariance(i, j) / (scale(i) * scale(j));
        count(block.series[i], block.series[j]) += 1.0;
      }
    }
  }
  return sum.cwiseQuotient(count.cwiseMax(1.0));
}

}  // namespace fathom
