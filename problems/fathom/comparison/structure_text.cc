// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/structure_text.h"

#include "fathom/report/format_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kClearLead = 1.65;  // standard errors, as the ladder asks for
constexpr double kClearShare = 1e-3;

std::string FamilyWords(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

// "output error", of several "surge output error, yaw least squares".
std::string FamiliesOf(const StructureRow& row, const std::vector<Dof>& dofs) {
  if (row.of_families.size() != dofs.size()) return FamilyWords(row.name);
  std::vector<std::string> of_dofs;
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    of_dofs.push_back(fmt::format("{} {}", Name(dofs[k]), FamilyWords(row.of_families[k])));
  }
  return fmt::format("{}", fmt::join(of_dofs, ", "));
}

Table TableOfModels(const StructureComparison& comparison) {
  Table table;
  table.columns = {{"model"}, {"numbers", true}};
  const StructureRow* const taken = comparison.Taken();
  for (const StructureRow& row : comparison.rows) {
    TableRow& line = table.rows.emplace_back();
    line.cells = {ModelName(row), fmt::format("{}", row.num_numbers)};
    line.flag = !row.is_usable  ? RowFlag::kUnusable
                : &row == taken ? RowFlag::kKept
                                : RowFlag::kNone;
  }
  return table;
}

void AddErrors(const StructureComparison& comparison,
               const char* which,
               std::array<double, 6> StructureRow::*nmae,
               Table* table) {
  for (const Dof dof : comparison.dofs) {
    table->columns.push_back({fmt::format("{}{}", Name(dof), which), true});
    for (std::size_t k = 0; k < comparison.rows.size(); ++k) {
      const double of_dof = (comparison.rows[k].*nmae)[static_cast<std::size_t>(Index(dof))];
      table->rows[k].cells.push_back(ShareText(of_dof, 3));
    }
  }
}

bool IsClear(const std::optional<UnseenGain>& gain) {
  return gain && gain->in_errors > kClearLead && gain->share > kClearShare;
}

std::string AgainstUncoupled(const StructureRow& taken,
                             const StructureRow* best,
                             const std::vector<Dof>& dofs) {
  if (best == nullptr) return " These logs give no usable models of one DOF for all of its DOFs.";
  if (!taken.gain) return "";
  const std::string others =
      fmt::format("those of the best models of one DOF each ({})", FamiliesOf(*best, dofs));
  const double share = 100.0 * taken.gain->share, errors = taken.gain->in_errors;
  if (IsClear(taken.gain)) {
    return fmt::format(
        " Over data that were not fitted its runs are nearer than {}, by {:.1f} % or {:.1f} "
        "standard errors.",
        others,
        share,
        errors);
  }
  if (errors < -kClearLead && -share > 100.0 * kClearShare) {
    return fmt::format(
        " Over data that were not fitted its runs are farther off than {}, by {:.1f} % or {:.1f} "
        "standard errors: take those.",
        others,
        -share,
        -errors);
  }
  return fmt::format(
      " Over data that were not fitted its runs are not clearly nearer than {}: {:+.1f} % or "
      "{:+.1f} standard errors.",
      others,
      share,
      errors);
}

std::string NearerStill(const StructureComparison& comparison) {
  std::vector<std::string> nearer;
  for (const StructureRow& row : comparison.rows) {
    if (row.is_of_one_dof || !IsClear(row.gain_over_taken)) continue;
    nearer.push_back(fmt::format("{} by {:.1f} % or {:.1f} standard errors",
                                 ModelName(row),
                                 100.0 * row.gain_over_taken->share,
                                 row.gain_over_taken->in_errors));
  }
  if (nearer.empty()) return "";
  return fmt::format(" Nearer still: {}.", fmt::join(nearer, "; "));
}

}  // namespace

std::string ModelName(const StructureRow& row) {
  if (row.is_of_one_dof) return "one DOF each, " + FamilyWords(row.name);
  return row.chosen.empty() ? row.name : fmt::format("{}: {}", row.name, row.chosen);
}

Table UnseenTable(const StructureComparison& comparison) {
  Table table = TableOfModels(comparison);
  table.caption =
      "NMAE over data that were not fitted, in free runs of 5 s. \"nearer\" is against the best "
      "models of one DOF each:";
  AddErrors(comparison, "", &StructureRow::unseen_nmae, &table);
  table.columns.push_back({"nearer", true});
  table.columns.push_back({"standard errors", true});
  table.columns.push_back({"fit [s]", true});
  for (std::size_t k = 0; k < comparison.rows.size(); ++k) {
    const StructureRow& row = comparison.rows[k];
    std::vector<std::string>& cells = table.rows[k].cells;
    cells.push_back(row.gain ? fmt::format("{:.1f} %", 100.0 * row.gain->share) : "-");
    cells.push_back(row.gain ? fmt::format("{:.1f}", row.gain->in_errors) : "-");
    cells.push_back(std::isfinite(row.seconds) ? fmt::format("{:.1f}", row.seconds) : "-");
  }
  return table;
}

Table FittedTable(const StructureComparison& comparison) {
  Table table = TableOfModels(comparison);
  const bool has_held_out = std::ranges::any_of(comparison.data, [](const CoupledData& log) {
    return std::ranges::any_of(log.segments, &CoupledSegment::is_held_out);
  });
  table.caption = fmt::format("NMAE over the training data{}, in free runs of {:g} s:",
                              has_held_out ? ", and over what was held out" : "",
                              comparison.window);
  AddErrors(comparison, "", &StructureRow::train_nmae, &table);
  if (has_held_out) AddErrors(comparison, ", held out", &StructureRow::held_out_nmae, &table);
  return table;
}

std::string StructureSentence(const StructureComparison& comparison) {
  const StructureRow* const taken = comparison.Taken();
  if (taken == nullptr) return "No structure that was asked for gives a usable model.";
  const std::string begin =
      taken->chosen.empty()
          ? fmt::format(
                "The least errors are those of {}, {} numbers.", taken->name, taken->num_numbers)
          : fmt::format("auto takes {}, {} numbers.", taken->chosen, taken->num_numbers);
  return begin + AgainstUncoupled(*taken, comparison.Best(), comparison.dofs) +
         NearerStill(comparison);
}

std::vector<std::string> CommentsOn(const StructureComparison& comparison) {
  std::vector<std::string> lines;
  for (const StructureRow& row : comparison.rows) {
    if (!row.is_usable) lines.push_back(fmt::format("! {}: {}", ModelName(row), row.message));
  }
  for (const std::string& remark : comparison.remarks) lines.push_back("note: " + remark);
  return lines;
}

}  // namespace fathom
