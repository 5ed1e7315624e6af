// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/uncoupled_rows.h"

#include "fathom/base/input_error.h"
#include "fathom/base/parallel_for.h"
#include "fathom/signal/joined_signals.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

using FitOfDof = std::optional<UncoupledModel<double>>;

// Of one family, by Index(Dof).
struct UncoupledFits {
  std::array<FitOfDof, 6> by_dof;
  std::string message;  // why the first that failed did
};

UncoupledFits FitEach(std::span<const Log> logs,
                      Family family,
                      const UncoupledRowsOptions& options) {
  UncoupledFits fits;
  for (const Dof dof : options.dofs) {
    std::string message;
    try {
      const Signals signals = JoinSignals(logs, dof, std::nullopt).all;
      const Identification one = Identify(signals, signals, family, options.identification);
      if (one.is_usable) fits.by_dof[static_cast<std::size_t>(Index(dof))] = one.fitted.model;
      message = one.is_usable ? "" : one.message;
    } catch (const InputError& error) {
      message = error.what();
    }
    if (fits.message.empty() && !message.empty()) {
      fits.message = fmt::format("{}: {}", Name(dof), message);
    }
  }
  return fits;
}

// Of the DOFs that have one.
CoupledModel ModelOf(const UncoupledFits& fits) {
  CoupledModel all;
  for (const Dof dof : kAllDofs) {
    const FitOfDof& fit = fits.by_dof[static_cast<std::size_t>(Index(dof))];
    if (!fit) continue;
    all.dofs.push_back(dof);
    SetValue(InertiaEntry(dof, dof), fit->inertia, &all);
    SetValue(LinearDampingEntry(dof, dof), fit->linear_damping, &all);
    SetValue(QuadraticDampingEntry(dof, dof), fit->quadratic_damping, &all);
    SetValue(dof == Dof::kHeave ? NetBuoyancyEntry() : OffsetEntry(dof), fit->buoyancy, &all);
  }
  return all;
}

// Of each fold, the logs that it trains on, with what is unseen held out.
std::vector<std::vector<Log>> LogsOfFolds(std::span<const Log> logs,
                                          const std::vector<Fold>& folds) {
  std::vector<std::vector<Log>> of_folds;
  for (const Fold& fold : folds) {
    std::vector<Log>& kept = of_folds.emplace_back(logs.begin(), logs.end());
    for (const CoupledData& unseen : fold.unseen) {
      for (const CoupledSegment& segment : unseen.segments) {
        kept[std::stoul(unseen.log)].held_out.push_back(
            {segment.time.front(), segment.time.back()});
      }
    }
    for (std::size_t k = logs.size(); k-- > 0;) {
      if (std::ranges::find(fold.train, std::to_string(k), &CoupledData::log) == fold.train.end()) {
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(k));
      }
    }
  }
  return of_folds;
}

// Each log by its index, so that folds tell which logs they hold.
std::vector<CoupledData> ByIndex(std::span<const CoupledData> data) {
  std::vector<CoupledData> named(data.begin(), data.end());
  for (std::size_t k = 0; k < named.size(); ++k) named[k].log = std::to_string(k);
  return named;
}

// A family's fits of all training data, and those of each fold.
struct FamilyFits {
  UncoupledFits all;
  std::vector<UncoupledFits> of_folds;
};

StructureRow EmptyRow(std::string name, const std::vector<Dof>& dofs) {
  StructureRow row;
  row.name = std::move(name);
  row.is_of_one_dof = true;
  row.num_numbers = dofs.size() * kNumParameters;
  row.train_nmae.fill(std::numeric_limits<double>::quiet_NaN());
  row.held_out_nmae = row.unseen_nmae = row.train_nmae;
  return row;
}

// The figures of the fits that there are. `data`, `folds`: what they are scored on.
void Score(const FamilyFits& fits,
           std::span<const CoupledData> data,
           const std::vector<Fold>& folds,
           const UncoupledRowsOptions& options,
           ScoredRow* scored) {
  StructureRow& row = scored->row;
  const CoupledModel model = ModelOf(fits.all);
  row.message = fits.all.message;
  if (model.dofs.empty()) return;
  auto prediction = PredictCoupled(model, data, options.window);
  if (!prediction) {
    row.message = "free runs of the models diverge";
    return;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    row.train_nmae[i] = prediction->train[i].nmae;
    row.held_out_nmae[i] = prediction->held_out[i].nmae;
  }
  row.prediction = *std::move(prediction);
  row.is_usable = model.dofs.size() == options.dofs.size();
  std::vector<CoupledModel> of_folds;
  std::vector<Dof> known = model.dofs;
  for (const UncoupledFits& fold : fits.of_folds) {
    const CoupledModel& of_fold = of_folds.emplace_back(ModelOf(fold));
    std::erase_if(
        known, [&](Dof dof) { return std::ranges::find(of_fold.dofs, dof) == of_fold.dofs.end(); });
  }
  scored->unseen = UnseenErrorsOf(folds, of_folds);
  row.unseen_nmae = NmaeOf(scored->unseen, known);
  scored->unseen.is_known = scored->unseen.is_known && known.size() == options.dofs.size();
}

// Of each DOF the fits of the family whose unseen errors are the least.
FamilyFits BestOf(const std::vector<FamilyFits>& fits,
                  const std::vector<ScoredRow>& rows,
                  const std::vector<Dof>& dofs,
                  std::vector<std::string>* chosen) {
  FamilyFits best;
  best.of_folds.resize(fits.front().of_folds.size());
  for (const Dof dof : dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    std::optional<std::size_t> least;
    for (std::size_t f = 0; f < rows.size(); ++f) {
      const double nmae = rows[f].row.unseen_nmae[at];
      if (!std::isfinite(nmae)) continue;
      if (!least || nmae < rows[*least].row.unseen_nmae[at]) least = f;
    }
    if (!least) {
      best.all.message = fmt::format("{}: no family has a model of it", Name(dof));
      continue;
    }
    chosen->push_back(rows[*least].row.name);
    best.all.by_dof[at] = fits[*least].all.by_dof[at];
    for (std::size_t k = 0; k < best.of_folds.size(); ++k) {
      best.of_folds[k].by_dof[at] = fits[*least].of_folds[k].by_dof[at];
    }
  }
  return best;
}

}  // namespace

std::vector<ScoredRow> UncoupledRows(std::span<const Log> logs,
                                     std::span<const CoupledData> data,
                                     const UncoupledRowsOptions& options) {
  const std::vector<Fold> folds = FoldsOf(ByIndex(data));
  const std::vector<std::vector<Log>> logs_of_folds = LogsOfFolds(logs, folds);
  std::vector<FamilyFits> fits;
  std::vector<ScoredRow> rows;
  for (const Family family : options.families) {
    FamilyFits& of_family = fits.emplace_back();
    ScoredRow& scored = rows.emplace_back();
    scored.row = EmptyRow(std::string(Name(family)), options.dofs);
    const auto begin = std::chrono::steady_clock::now();
    of_family.all = FitEach(logs, family, options);
    scored.row.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    of_family.of_folds.resize(folds.size());
    ParallelFor(static_cast<int>(folds.size()), [&](int f) {
      const auto at = static_cast<std::size_t>(f);
      of_family.of_folds[at] = FitEach(logs_of_folds[at], family, options);
    });
    Score(of_family, data, folds, options, &scored);
  }
  if (rows.size() < 2) return rows;
  ScoredRow best;
  best.row = EmptyRow("best", options.dofs);
  const FamilyFits of_best = BestOf(fits, rows, options.dofs, &best.row.of_families);
  Score(of_best, data, folds, options, &best);
  rows.push_back(std::move(best));
  return rows;
}

}  // namespace fathom
