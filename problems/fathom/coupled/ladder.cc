// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/ladder.h"

#include "fathom/simulate/coupled/coupled_prediction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace fathom {
namespace {

constexpr double kUnseenHorizon = 5.0;  // [s]
constexpr std::size_t kMostFolds = 4;
constexpr double kLeastErrors = 1.65;  // that a rung must win by, in standard errors
constexpr double kStillThere = 3.0;    // standard deviations that an entry keeps
constexpr std::size_t kMostNamed = 8;
constexpr double kAlike = 0.9;  // correlation of two that are not told apart

using Kind = FreeEntry::Kind;

// Data to fit and data to predict.
struct Fold {
  std::vector<CoupledData> train, unseen;
};

// A segment in `num` parts of the same length.
std::vector<CoupledSegment> Parts(const CoupledSegment& segment, std::size_t num) {
  std::vector<CoupledSegment> parts;
  const double length = (segment.time.back() - segment.time.front()) / static_cast<double>(num);
  for (const SampleWindow& range : WindowsOf(segment, length)) {
    CoupledSegment& part = parts.emplace_back();
    const auto cut = [](const auto& all, std::size_t begin, std::size_t end) {
      return std::vector(all.begin() + static_cast<std::ptrdiff_t>(begin),
                         all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    part.time = cut(segment.time, range.begin, range.end);
    part.velocity = cut(segment.velocity, range.begin, range.end);
    part.is_held_out = segment.is_held_out;
    if (segment.pose_time.empty()) continue;
    const auto first = segment.pose_time.begin();
    const auto from = std::lower_bound(first, segment.pose_time.end(), part.time.front()) - first;
    const auto to = std::upper_bound(first, segment.pose_time.end(), part.time.back()) - first;
    part.pose_time =
        cut(segment.pose_time, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    part.position =
        cut(segment.position, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    if (!segment.attitude.empty()) {
      part.attitude =
          cut(segment.attitude, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
    }
  }
  return parts;
}

CoupledData Without(const CoupledData& log) {
  CoupledData empty = log;
  empty.segments.clear();
  return empty;
}

// Whole logs in turn where there are several, else quarters of one.
std::vector<Fold> FoldsOf(std::span<const CoupledData> logs) {
  const std::size_t num = logs.size() > 1 ? std::min(logs.size(), kMostFolds) : kMostFolds;
  std::vector<Fold> folds(num);
  for (std::size_t f = 0; f < num; ++f) {
    for (std::size_t k = 0; k < logs.size(); ++k) {
      folds[f].train.push_back(Without(logs[k]));
      folds[f].unseen.push_back(Without(logs[k]));
      for (const CoupledSegment& segment : logs[k].segments) {
        if (segment.is_held_out) continue;
        if (logs.size() > 1) {
          (k % num == f ? folds[f].unseen : folds[f].train).back().segments.push_back(segment);
          continue;
        }
        const std::vector<CoupledSegment> parts = Parts(segment, num);
        for (std::size_t p = 0; p < parts.size(); ++p) {
          (p % num == f ? folds[f].unseen : folds[f].train).back().segments.push_back(parts[p]);
        }
      }
    }
    const auto is_empty = [](const CoupledData& log) { return log.segments.empty(); };
    std::erase_if(folds[f].train, is_empty);
    std::erase_if(folds[f].unseen, is_empty);
  }
  std::erase_if(folds, [](const Fold& fold) { return fold.train.empty() || fold.unseen.empty(); });
  return folds;
}

// Mean absolute errors by window, and what moved in all.
struct UnseenErrors {
  bool is_known = false;
  std::vector<Vector6> by_window;
  Vector6 error = Vector6::Zero(), motion = Vector6::Zero();  // sums over samples
};

void AddErrors(const std::vector<CoupledData>& logs,
               const CoupledPrediction& prediction,
               UnseenErrors* errors) {
  for (std::size_t k = 0; k < logs.size(); ++k) {
    for (std::size_t s = 0; s < logs[k].segments.size(); ++s) {
      const CoupledSegment& segment = logs[k].segments[s];
      for (const SampleWindow& window : WindowsOf(segment, kUnseenHorizon)) {
        Vector6 sum = Vector6::Zero();
        for (std::size_t i = window.begin; i < window.end; ++i) {
          const Vector6 miss = segment.velocity[i] - prediction.velocity[k][s][i];
          for (Eigen::Index row = 0; row < 6; ++row) {
            if (!std::isfinite(miss[row])) continue;
            sum[row] += std::abs(miss[row]);
            errors->motion[row] += std::abs(segment.velocity[i][row]);
          }
        }
        errors->error += sum;
        errors->by_window.push_back(sum / static_cast<double>(window.end - window.begin));
      }
    }
  }
}

UnseenErrors UnseenErrorsOf(const std::vector<Fold>& folds,
                            const MotionStructure& structure,
                            const CoupledSummary& fit,
                            CoupledFitOptions options) {
  UnseenErrors errors;
  options.start = fit.model;
  options.noise = fit.noise;
  options.learns_noise = false;
  for (const Fold& fold : folds) {
    const CoupledSummary part = FitCoupled(fold.train, structure, options);
    if (!part.converged) return errors;
    const auto prediction = PredictCoupled(part.model, fold.unseen, kUnseenHorizon);
    if (!prediction) return errors;
    AddErrors(fold.unseen, *prediction, &errors);
  }
  errors.is_known = !errors.by_window.empty();
  return errors;
}

// By how much `b` is nearer than `a`: the mean over DOFs of the shares that errors shrink by.
void Compare(const UnseenErrors& a,
             const UnseenErrors& b,
             const std::vector<Dof>& dofs,
             LadderRung* rung) {
  const std::size_t n = a.by_window.size();
  Vector6 mean = Vector6::Zero();
  for (const Vector6& window : a.by_window) mean += window / static_cast<double>(n);
  double sum = 0.0, squares = 0.0;
  for (std::size_t w = 0; w < n; ++w) {
    double gain = 0.0;
    for (const Dof dof : dofs) {
      const auto row = Index(dof);
      if (mean[row] > 0.0) {
        gain += (a.by_window[w][row] - b.by_window[w][row]) / mean[row] /
                static_cast<double>(dofs.size());
      }
    }
    sum += gain;
    squares += gain * gain;
  }
  const double num = static_cast<double>(n);
  rung->gain = sum / num;
  const double variance = n > 1 ? (squares - num * rung->gain * rung->gain) / (num - 1.0) : 0.0;
  rung->gain_in_errors = variance > 0.0 ? rung->gain / std::sqrt(variance / num) : 0.0;
}

std::array<double, 6> NmaeOf(const UnseenErrors& errors, const std::vector<Dof>& dofs) {
  std::array<double, 6> nmae;
  nmae.fill(std::numeric_limits<double>::quiet_NaN());
  if (!errors.is_known) return nmae;
  for (const Dof dof : dofs) {
    const auto row = Index(dof);
    nmae[static_cast<std::size_t>(row)] = errors.error[row] / errors.motion[row];
  }
  return nmae;
}

// The two-sided quantile of a standard normal number: P(|z| > result) = p.
double NormalQuantile(double p) {
  double low = 0.0, high = 10.0;
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (low + high);
    (std::erfc(z / std::numbers::sqrt2) > p ? low : high) = z;
  }
  return low;
}

bool Holds(const MotionStructure& structure, const FreeEntry& entry) {
  return std::find(structure.entries.begin(), structure.entries.end(), entry) !=
         structure.entries.end();
}

// Everything off the diagonal, and the thrusters.
std::vector<FreeEntry> CandidatesBeyond(const MotionStructure& structure,
                                        const std::vector<std::string>& thrusters) {
  std::vector<FreeEntry> all;
  for (const Dof row : structure.dofs) {
    for (const Dof column : structure.dofs) {
      if (row == column) continue;
      if (row < column) all.push_back(InertiaEntry(row, column));
      all.push_back(LinearDampingEntry(row, column));
    }
  }
  for (const std::string& thruster : thrusters) all.push_back(ThrustGainEntry(thruster));
  std::erase_if(all, [&](const FreeEntry& entry) { return Holds(structure, entry); });
  return all;
}

double StdOf(const CoupledSummary& fit, const FreeEntry& entry) {
  const auto at = std::find(fit.entries.begin(), fit.entries.end(), entry) - fit.entries.begin();
  return std::sqrt(fit.covariance(at, at));
}

// How far from where it has no effect, in standard deviations.
double StrengthOf(const CoupledSummary& fit, const FreeEntry& entry) {
  const double without = entry.kind == Kind::kThrustGain ? 1.0 : 0.0;
  return std::abs(ValueIn(fit.model, entry) - without) / StdOf(fit, entry);
}

// A start for one entry more, where its test puts it.
CoupledModel StartedAt(CoupledModel model, const EntryTest& test) {
  const double before = ValueIn(model, test.entry);
  SetValue(test.entry, before + test.value, &model);
  return model;
}

struct EntrySearch {
  MotionStructure structure;
  CoupledSummary fit;
  std::vector<FreeEntry> added;
  std::vector<std::vector<FreeEntry>> alike;  // to each of them
};

// Adds the entry that the data ask for most until they ask for none; an entry that a later one
// makes needless goes.
EntrySearch SearchEntries(const CoupledLogs& logs,
                          const MotionStructure& from,
                          const CoupledSummary& fit,
                          const LadderOptions& options) {
  EntrySearch search = {from, fit, {}, {}};
  std::vector<FreeEntry> banned;
  while (search.added.size() < kMostNamed) {
    std::vector<FreeEntry> candidates = CandidatesBeyond(search.structure, options.thrusters);
    std::erase_if(candidates, [&](const FreeEntry& entry) {
      return std::find(banned.begin(), banned.end(), entry) != banned.end();
    });
    if (candidates.empty()) break;
    CoupledSummary here = search.fit;
    if (here.starts.empty()) {
      // Blocks were fitted one by one; the tests need one run of all.
      CoupledFitOptions again = options.fit;
      again.start = here.model;
      here = FitCoupled(logs.data, search.structure, again);
      if (!here.IsUsable()) break;
      search.fit = here;
    }
    const std::vector<EntryTest> tests = TestEntries(logs.data, here, candidates, options.fit);
    const auto best =
        std::max_element(tests.begin(), tests.end(), [](const auto& a, const auto& b) {
          return std::abs(a.z) < std::abs(b.z);
        });
    const double least =
        NormalQuantile(options.false_alarm / static_cast<double>(candidates.size()));
    if (best == tests.end() || std::abs(best->z) < least) break;
    MotionStructure longer = search.structure;
    longer.entries.push_back(best->entry);
    CoupledFitOptions next = options.fit;
    next.start = StartedAt(here.model, *best);
    next.noise = here.noise;
    CoupledSummary found = FitCoupled(logs.data, longer, next);
    if (!found.IsUsable() || StrengthOf(found, best->entry) < kStillThere) {
      banned.push_back(best->entry);
      continue;
    }
    std::vector<FreeEntry> alike;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (std::abs(best->likeness[c]) > kAlike && !(candidates[c] == best->entry)) {
        alike.push_back(candidates[c]);
      }
    }
    search.structure = std::move(longer);
    search.fit = std::move(found);
    search.added.push_back(best->entry);
    search.alike.push_back(std::move(alike));
    // What has become needless.
    for (std::size_t k = 0; k < search.added.size(); ++k) {
      if (StrengthOf(search.fit, search.added[k]) >= kStillThere) continue;
      const FreeEntry gone = search.added[k];
      std::erase(search.structure.entries, gone);
      search.added.erase(search.added.begin() + static_cast<std::ptrdiff_t>(k));
      search.alike.erase(search.alike.begin() + static_cast<std::ptrdiff_t>(k));
      banned.push_back(gone);
      CoupledFitOptions again = options.fit;
      again.start = search.fit.model;
      again.noise = search.fit.noise;
      SetValue(gone, gone.kind == Kind::kThrustGain ? 1.0 : 0.0, &*again.start);
      search.fit = FitCoupled(logs.data, search.structure, again);
      break;
    }
  }
  return search;
}

// What stands, with all entries of a standard structure.
MotionStructure Joined(MotionStructure stands, const MotionStructure& standard) {
  for (const FreeEntry& entry : standard.entries) {
    if (!Holds(stands, entry)) stands.entries.push_back(entry);
  }
  return stands;
}

}  // namespace

Ladder ClimbLadder(const CoupledLogs& logs,
                   const std::vector<Dof>& dofs,
                   const LadderOptions& options) {
  Ladder ladder;
  const std::vector<Fold> folds = FoldsOf(logs.data);
  UnseenErrors stands;
  const auto try_rung =
      [&](std::string name, const MotionStructure& structure, CoupledSummary fit) {
        LadderRung& rung = ladder.rungs.emplace_back();
        rung.name = std::move(name);
        rung.structure = structure;
        rung.fit = std::move(fit);
        rung.unseen_nmae = NmaeOf({}, dofs);
        if (!rung.fit.converged) return;
        UnseenErrors errors = UnseenErrorsOf(folds, structure, rung.fit, options.fit);
        rung.unseen_nmae = NmaeOf(errors, dofs);
        if (!errors.is_known) return;
        if (stands.is_known) Compare(stands, errors, dofs, &rung);
        rung.is_accepted =
            rung.fit.IsUsable() && (!stands.is_known || rung.gain_in_errors > kLeastErrors);
        if (!rung.is_accepted) return;
        ladder.accepted = ladder.rungs.size() - 1;
        stands = std::move(errors);
      };
  const auto fit_from_accepted = [&](const MotionStructure& structure) {
    CoupledFitOptions fit = options.fit;
    const bool has_start = !ladder.rungs.empty() && ladder.rungs[ladder.accepted].fit.converged;
    if (has_start) fit.start = ladder.rungs[ladder.accepted].fit.model;
    return FitBlocks(logs, structure, fit);
  };
  for (const StandardStructure standard :
       {StandardStructure::kDiagonal, StandardStructure::kCoriolis}) {
    const MotionStructure structure = StructureOf(standard, dofs);
    try_rung(std::string(Name(standard)), structure, fit_from_accepted(structure));
  }
  std::vector<FreeEntry> added;
  std::vector<std::vector<FreeEntry>> alike;
  if (ladder.rungs[ladder.accepted].fit.converged) {
    EntrySearch search = SearchEntries(
        logs, ladder.rungs[ladder.accepted].structure, ladder.rungs[ladder.accepted].fit, options);
    if (!search.added.empty()) {
      try_rung("entries", search.structure, std::move(search.fit));
      if (ladder.rungs.back().is_accepted) {
        added = std::move(search.added);
        alike = std::move(search.alike);
      }
    }
  }
  for (const StandardStructure standard :
       {StandardStructure::kSymmetric, StandardStructure::kFull}) {
    const MotionStructure structure =
        Joined(ladder.rungs[ladder.accepted].structure, StructureOf(standard, dofs));
    if (structure.entries.size() == ladder.rungs[ladder.accepted].structure.entries.size())
      continue;
    try_rung(std::string(Name(standard)), structure, fit_from_accepted(structure));
  }
  const LadderRung& accepted = ladder.rungs[ladder.accepted];
  for (std::size_t k = 0; k < added.size(); ++k) {
    ladder.named.push_back(
        {added[k], ValueIn(accepted.fit.model, added[k]), StdOf(accepted.fit, added[k]), alike[k]});
  }
  return ladder;
}

}  // namespace fathom
