// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/structure_comparison.h"

#include "fathom/base/names_of_dofs.h"
#include "fathom/comparison/uncoupled_rows.h"
#include "fathom/coupled/unseen_errors.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr StandardStructure kInOrder[] = {StandardStructure::kDiagonal,
                                          StandardStructure::kCoriolis,
                                          StandardStructure::kLift,
                                          StandardStructure::kSymmetric,
                                          StandardStructure::kFull,
                                          StandardStructure::kLopsided};

// Those that free what none before frees. `remarks`: of the others.
std::vector<StandardStructure> DistinctStructures(std::span<const Log> logs,
                                                  const std::vector<Dof>& dofs,
                                                  std::vector<std::string>* remarks) {
  const bool has_fins =
      std::ranges::any_of(logs, [](const Log& log) { return log.fins.has_value(); });
  std::vector<StandardStructure> distinct;
  std::vector<std::string_view> left_out;
  for (const StandardStructure one : kInOrder) {
    if (one == StandardStructure::kLift) {
      if (has_fins) distinct.push_back(one);
      continue;
    }
    const MotionStructure structure = StructureOf(one, dofs);
    const bool is_new = std::ranges::none_of(distinct, [&](StandardStructure other) {
      const MotionStructure before = StructureOf(other, dofs);
      return other != StandardStructure::kLift && before.coriolis == structure.coriolis &&
             before.entries == structure.entries;
    });
    if (is_new) {
      distinct.push_back(one);
    } else {
      left_out.push_back(Name(one));
    }
  }
  if (!left_out.empty()) {
    remarks->push_back(fmt::format("Left out: {}, which {} nothing more of {}.",
                                   fmt::join(left_out, ", "),
                                   left_out.size() > 1 ? "free" : "frees",
                                   NamesOf(dofs)));
  }
  return distinct;
}

double MeanUnseen(const StructureRow& row, const std::vector<Dof>& dofs) {
  double sum = 0.0;
  for (const Dof dof : dofs) sum += row.unseen_nmae[static_cast<std::size_t>(Index(dof))];
  return sum / static_cast<double>(dofs.size());
}

void SetFigures(const FittedCoupledModel& fitted, StructureRow* row) {
  for (std::size_t i = 0; i < 6; ++i) {
    row->train_nmae[i] = fitted.train[i].nmae;
    row->held_out_nmae[i] = fitted.held_out[i].nmae;
  }
}

// Of a structure, of that which the ladder chooses where there is none. Fills what of the
// comparison is that of all structures.
ScoredRow RowOf(std::span<const Log> logs,
                const StructureComparisonOptions& options,
                std::optional<StandardStructure> structure,
                StructureComparison* comparison) {
  ScoredRow scored;
  StructureRow& row = scored.row;
  row.name = structure ? std::string(Name(*structure)) : "auto";
  row.train_nmae.fill(std::numeric_limits<double>::quiet_NaN());
  row.held_out_nmae = row.unseen_nmae = row.train_nmae;
  const auto begin = std::chrono::steady_clock::now();
  CoupledIdentification identified =
      IdentifyCoupled({logs.begin(), logs.end()}, {options.dofs, structure, options.fit});
  row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  row.is_usable = identified.is_usable;
  row.message = identified.is_usable ? "" : identified.message;
  row.num_numbers = identified.structure.entries.size();
  if (identified.fit.converged) {
    scored.unseen = UnseenErrorsOf(
        FoldsOf(identified.data), identified.structure, identified.fit, identified.fit_options);
    row.unseen_nmae = NmaeOf(scored.unseen, options.dofs);
  }
  if (identified.is_usable) SetFigures(identified.fitted, &row);
  row.prediction = std::move(identified.prediction);
  if (identified.ladder) {
    row.chosen = identified.ladder->rungs[identified.ladder->accepted].name;
    comparison->ladder = std::move(identified.ladder);
  }
  if (comparison->data.empty()) {
    comparison->data = std::move(identified.data);
    std::ranges::move(identified.remarks, std::back_inserter(comparison->remarks));
  }
  return scored;
}

}  // namespace

const StructureRow* StructureComparison::Best() const {
  const StructureRow* last = nullptr;  // "best" stands behind the families
  for (const StructureRow& row : rows) {
    if (row.is_of_one_dof) last = &row;
  }
  return last != nullptr && last->is_usable ? last : nullptr;
}

const StructureRow* StructureComparison::Taken() const {
  const auto at = std::ranges::find(rows, "auto", &StructureRow::name);
  if (at != rows.end()) return at->is_usable ? &*at : nullptr;
  const StructureRow* least = nullptr;
  for (const StructureRow& row : rows) {
    const double mean = MeanUnseen(row, dofs);
    if (row.is_of_one_dof || !row.is_usable || !std::isfinite(mean)) continue;
    if (least == nullptr || mean < MeanUnseen(*least, dofs)) least = &row;
  }
  return least;
}

StructureComparison CompareStructures(std::span<const Log> logs,
                                      const StructureComparisonOptions& options) {
  StructureComparison comparison;
  comparison.dofs = options.dofs;
  comparison.window = options.fit.window;
  std::vector<std::string_view> names;
  for (const Log& log : logs) names.push_back(log.name);
  comparison.log_name = fmt::format("{}", fmt::join(names, ", "));
  const std::vector<StandardStructure> structures =
      options.structures ? *options.structures
                         : DistinctStructures(logs, options.dofs, &comparison.remarks);
  std::vector<ScoredRow> coupled, all;
  for (const StandardStructure structure : structures) {
    coupled.push_back(RowOf(logs, options, structure, &comparison));
  }
  if (options.has_auto) coupled.push_back(RowOf(logs, options, std::nullopt, &comparison));
  all = UncoupledRows(logs,
                      comparison.data,
                      {options.dofs, options.families, options.identification, options.fit.window});
  std::ranges::move(coupled, std::back_inserter(all));
  for (const ScoredRow& scored : all) comparison.rows.push_back(scored.row);
  const auto compare_with = [&](const StructureRow* other,
                                std::optional<UnseenGain> StructureRow::*gain) {
    if (other == nullptr) return;
    const UnseenErrors& to_beat =
        all[static_cast<std::size_t>(other - comparison.rows.data())].unseen;
    if (!to_beat.is_known) return;
    for (std::size_t k = 0; k < all.size(); ++k) {
      StructureRow& row = comparison.rows[k];
      if (&row == other || !row.is_usable || !all[k].unseen.is_known) continue;
      row.*gain = GainOf(to_beat, all[k].unseen, options.dofs);
    }
  };
  compare_with(comparison.Best(), &StructureRow::gain);
  compare_with(comparison.Taken(), &StructureRow::gain_over_taken);
  return comparison;
}

}  // namespace fathom
