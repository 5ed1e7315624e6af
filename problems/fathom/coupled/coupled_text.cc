// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_text.h"

#include "fathom/report/format_value.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::string EntryUnit(const FreeEntry& entry, const std::string& force_unit) {
  return UnitText(UnitOf(entry, force_unit));
}

// Of an entry, its value with its deviation where it was identified.
std::string MatrixCell(const FittedCoupledModel& fitted, const FreeEntry& entry) {
  const double value = ValueIn(fitted.model, entry);
  const auto at = std::find(fitted.entries.begin(), fitted.entries.end(), entry);
  if (at == fitted.entries.end()) return value == 0.0 ? "-" : FormatValue(value);
  const auto k = at - fitted.entries.begin();
  return FormatValue(value, std::sqrt(fitted.covariance(k, k)));
}

Table MatrixTable(const char* caption,
                  const FittedCoupledModel& fitted,
                  FreeEntry (*entry)(Dof row, Dof column)) {
  Table table;
  table.caption = caption;
  table.columns = {{""}};
  for (const Dof dof : fitted.model.dofs) table.columns.push_back({std::string(Name(dof)), true});
  for (const Dof row : fitted.model.dofs) {
    TableRow& cells = table.rows.emplace_back();
    cells.cells = {std::string(Name(row))};
    for (const Dof column : fitted.model.dofs) {
      cells.cells.push_back(MatrixCell(fitted, entry(row, column)));
    }
  }
  return table;
}

std::string Named(const NamedEntry& named) {
  std::string text =
      fmt::format("{} ({})", NameOf(named.entry), FormatValue(named.value, named.std));
  if (named.not_told_apart.empty()) return text;
  std::vector<std::string> others;
  for (const FreeEntry& entry : named.not_told_apart) others.push_back(NameOf(entry));
  return text + fmt::format(", or in its place {}", fmt::join(others, " or "));
}

}  // namespace

Table CoupledEntryTable(const FittedCoupledModel& fitted) {
  Table table;
  table.columns = {{"number"}, {"value", true}, {"unit"}, {"95 % interval", true}};
  for (std::size_t k = 0; k < fitted.entries.size(); ++k) {
    const FreeEntry& entry = fitted.entries[k];
    const auto at = static_cast<Eigen::Index>(k);
    const double value = ValueIn(fitted.model, entry), std = std::sqrt(fitted.covariance(at, at));
    table.rows.push_back({{NameOf(entry),
                           FormatValue(value, std),
                           EntryUnit(entry, fitted.force_unit),
                           FormatInterval(value, std, LowerBoundOf(entry))}});
  }
  return table;
}

std::vector<Table> CoupledMatrixTables(const FittedCoupledModel& fitted) {
  std::vector<Table> tables;
  const auto add = [&](const char* caption, const Matrix6& matrix, auto entry) {
    if (!matrix.isZero(0.0)) tables.push_back(MatrixTable(caption, fitted, entry));
  };
  add("Inertia M: the force along a row for an acceleration in a column. SI units.",
      fitted.model.inertia,
      InertiaEntry);
  add("Linear damping: the force along a row for a velocity in a column. SI units.",
      fitted.model.linear_damping,
      LinearDampingEntry);
  add("Quadratic damping: the same for a velocity times its size. SI units.",
      fitted.model.quadratic_damping,
      QuadraticDampingEntry);
  return tables;
}

Table CoupledFigureTable(const FittedCoupledModel& fitted) {
  Table table;
  table.caption =
      fmt::format("Free runs, begun anew from the measured state every {:g} s:", fitted.horizon);
  table.columns = {{"DOF"}, {"MAE", true}, {"unit"}, {"NMAE", true}, {"NMAE held out", true}};
  for (const Dof dof : fitted.model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    table.rows.push_back({{std::string(Name(dof)),
                           fmt::format("{:.4g}", fitted.train[at].mae),
                           std::string(VelocityUnit(dof)),
                           ShareText(fitted.train[at].nmae, 3),
                           ShareText(fitted.held_out[at].nmae, 3)}});
  }
  return table;
}

Table LadderTable(const Ladder& ladder, const std::vector<Dof>& dofs) {
  Table table;
  table.caption =
      "Structures, by their NMAE over data that were not fitted, in free runs of 5 s. \"nearer\" "
      "is "
      "against the one that stood before:";
  table.columns = {{"structure"}, {"numbers", true}};
  for (const Dof dof : dofs) table.columns.push_back({std::string(Name(dof)), true});
  table.columns.push_back({"nearer", true});
  table.columns.push_back({"standard errors", true});
  for (std::size_t k = 0; k < ladder.rungs.size(); ++k) {
    const LadderRung& rung = ladder.rungs[k];
    TableRow& row = table.rows.emplace_back();
    row.cells = {rung.name, fmt::format("{}", rung.structure.entries.size())};
    for (const Dof dof : dofs) {
      row.cells.push_back(ShareText(rung.unseen_nmae[static_cast<std::size_t>(Index(dof))], 3));
    }
    const bool is_compared = rung.gain.in_errors != 0.0;
    row.cells.push_back(is_compared ? fmt::format("{:.1f} %", 100.0 * rung.gain.share) : "-");
    row.cells.push_back(is_compared ? fmt::format("{:.1f}", rung.gain.in_errors) : "-");
    if (!rung.fit.IsUsable()) row.flag = RowFlag::kUnusable;
    if (k == ladder.accepted && rung.fit.IsUsable()) row.flag = RowFlag::kBest;
  }
  return table;
}

std::string NotFittedSentence(const Ladder& ladder) {
  if (ladder.not_asked_for.empty()) return "";
  return fmt::format("Not fitted, since nothing asks for their numbers: {}.",
                     fmt::join(ladder.not_asked_for, ", "));
}

std::string LadderSentence(const Ladder& ladder) {
  const LadderRung& accepted = ladder.rungs[ladder.accepted];
  std::string text = fmt::format("Structure: {}.", accepted.name);
  const bool has_won = std::ranges::any_of(ladder.rungs, [](const LadderRung& rung) {
    return rung.name == "coriolis" && rung.is_accepted;
  });
  if (has_won) text += " The Coriolis forces C(nu) are in the data.";
  std::vector<std::string> names;
  for (const NamedEntry& named : ladder.named) names.push_back(Named(named));
  text += names.empty() ? " The data show no number beyond it."
                        : fmt::format(" The data show {}.", fmt::join(names, "; "));
  const std::string not_fitted = NotFittedSentence(ladder);
  if (!not_fitted.empty()) text += " " + not_fitted;
  return text + "\n";
}

std::string FormatCoupledIdentification(const CoupledIdentification& identified) {
  const FittedCoupledModel& fitted = identified.fitted;
  std::string text;
  if (identified.ladder) {
    text += LadderSentence(*identified.ladder) + "\n";
    text += FormatTable(LadderTable(*identified.ladder, fitted.model.dofs)) + "\n";
  }
  text += FormatTable(CoupledEntryTable(fitted)) + "\n";
  text += FormatTable(CoupledFigureTable(fitted));
  for (const std::string& caveat : fitted.caveats) text += "note: " + caveat + "\n";
  return text;
}

}  // namespace fathom
