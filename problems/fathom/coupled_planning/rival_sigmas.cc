// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/rival_sigmas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

// Of rows of unit length: keeps one that leaves no trace from making the rest infinite.
constexpr double kTraceOfRival = 1e-12;

Eigen::Index PlaceOf(const FreeEntry& entry, std::vector<FreeEntry>* entries) {
  const auto found = std::ranges::find(*entries, entry);
  const Eigen::Index place = found - entries->begin();
  if (found == entries->end()) entries->push_back(entry);
  return place;
}

// All that may imitate the named cause.
std::vector<Eigen::Index> OthersOf(const PlacedRival& pair, Eigen::Index num_of_model) {
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < num_of_model; ++i) {
    if (i != pair.named && i != pair.rival) others.push_back(i);
  }
  others.push_back(pair.rival);
  return others;
}

double SigmasBetween(const PlacedRival& pair,
                     Eigen::Index num_of_model,
                     const Eigen::MatrixXd& information) {
  const std::vector<Eigen::Index> others = OthersOf(pair, num_of_model);
  const Eigen::MatrixXd of_others = information(others, others);
  const Eigen::VectorXd scales =
      of_others.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
  Eigen::MatrixXd scaled = scales.asDiagonal() * of_others * scales.asDiagonal();
  scaled.diagonal().array() += kTraceOfRival;
  const Eigen::VectorXd shared = scales.cwiseProduct(information(others, pair.named).col(0));
  const double left = information(pair.named, pair.named) - shared.dot(scaled.ldlt().solve(shared));
  return std::abs(pair.value) * std::sqrt(std::max(0.0, left));
}

}  // namespace

std::vector<PlacedRival> PlaceRivals(const std::vector<EntryRival>& rivals,
                                     std::vector<FreeEntry>* entries) {
  std::vector<PlacedRival> placed;
  for (const EntryRival& pair : rivals) {
    const Eigen::Index named = PlaceOf(pair.named, entries);
    placed.push_back({named, PlaceOf(pair.rival, entries), pair.value});
  }
  return placed;
}

std::vector<double> SigmasOf(const std::vector<PlacedRival>& rivals,
                             Eigen::Index num_of_model,
                             const Eigen::MatrixXd& information) {
  std::vector<double> sigmas;
  for (const PlacedRival& pair : rivals) {
    sigmas.push_back(SigmasBetween(pair, num_of_model, information));
  }
  return sigmas;
}

double WorthOfSigmas(const std::vector<double>& sigmas) {
  double sum = 0.0;
  for (const double lambda : sigmas) sum += 1.0 / (1.0 + lambda * lambda);
  return -std::log(sum);
}

}  // namespace fathom
