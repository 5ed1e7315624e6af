// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/rival_sigmas.h"

#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// All that may imitate the true cause; the assumed one is the last.
std::vector<Eigen::Index> OthersOf(const PlacedRival& pair, Eigen::Index num_of_model) {
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < num_of_model; ++i) {
    if (i != pair.truth && i != pair.assumed) others.push_back(i);
  }
  others.push_back(pair.assumed);
  return others;
}

// The best imitation of the true cause.
struct Imitation {
  double left = 0.0;     // squares of what is left, of the true cause at value 1
  double assumed = 0.0;  // value of the assumed cause, of the true one at value 1
};

Imitation ImitationOf(const PlacedRival& pair,
                      Eigen::Index num_of_model,
                      const Eigen::MatrixXd& information) {
  const std::vector<Eigen::Index> others = OthersOf(pair, num_of_model);
  const Eigen::MatrixXd of_others = information(others, others);
  const Eigen::VectorXd scales =
      of_others.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
  Eigen::MatrixXd scaled = scales.asDiagonal() * of_others * scales.asDiagonal();
  scaled.diagonal().array() += kTraceOfRival;
  const Eigen::VectorXd shared = scales.cwiseProduct(information(others, pair.truth).col(0));
  const Eigen::VectorXd by = SolveSymmetric(scaled, shared);
  const double left = information(pair.truth, pair.truth) - shared.dot(by);
  return {std::max(0.0, left), by[by.size() - 1] * scales[scales.size() - 1]};
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

std::vector<PlacedRival> BothWays(const std::vector<PlacedRival>& rivals,
                                  Eigen::Index num_of_model,
                                  const Eigen::MatrixXd& information) {
  std::vector<PlacedRival> both = rivals;
  for (const PlacedRival& pair : rivals) {
    const double share = ImitationOf(pair, num_of_model, information).assumed;
    both.push_back({pair.assumed, pair.truth, share * pair.value});
  }
  return both;
}

std::vector<double> SigmasOf(const std::vector<PlacedRival>& rivals,
                             Eigen::Index num_of_model,
                             const Eigen::MatrixXd& information) {
  std::vector<double> sigmas;
  for (const PlacedRival& pair : rivals) {
    const double left = ImitationOf(pair, num_of_model, information).left;
    sigmas.push_back(std::abs(pair.value) * std::sqrt(left));
  }
  return sigmas;
}

double WorthOfSigmas(const std::vector<double>& sigmas) {
  double sum = 0.0;
  for (const double lambda : sigmas) sum += 1.0 / (1.0 + lambda * lambda);
  return -std::log(sum);
}

}  // namespace fathom
