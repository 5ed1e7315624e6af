// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison_page.h"

#include "fathom/base/not_known.h"
#include "fathom/comparison/comparison_panels.h"
#include "fathom/comparison/recommendation.h"
#include "fathom/findings/explain_first.h"
#include "fathom/identification/identification_text.h"
#include "fathom/identification/remains_fold.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::string Figure(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

std::string Capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

// "Adaptive, velocity.csv (6.9 %)".
std::string WithScore(const DofComparison& comparison, const Identification& row) {
  return fmt::format("{} ({:.1f} %)", ModelName(row), 100.0 * ScoreOf(comparison, row));
}

std::string Sentence(const DofComparison& comparison) {
  const std::string dof = Capitalised(std::string(Name(comparison.dof)));
  const Recommendation recommendation = Recommend(comparison);
  if (recommendation.taken == nullptr) {
    return fmt::format("{}: no family found a usable model.", dof);
  }
  const Identification& taken = *recommendation.taken;
  std::vector<std::string> as_good;
  for (const Identification* row : recommendation.as_good) {
    as_good.push_back(WithScore(comparison, *row));
  }
  const double score = ScoreOf(comparison, taken), noise = NoiseNmae(comparison);
  const std::string on = comparison.HasHeldOut()
                             ? "on held-out data"
                             : "on the data that it was fitted to (no data are held out)";
  if (!(score < kScoreAtRest)) {
    return fmt::format(
        "{}: take none. Simulated from the command alone, the best one, {}, misses {:.0f} % of the "
        "speed {}; a model that stands still misses 100 %.",
        dof,
        ModelName(taken),
        100.0 * score,
        on);
  }
  const std::string first = ExplainFirst(comparison.findings);
  return fmt::format(
      "{}: {}take {}{}. Simulated from the command alone, it misses {:.1f} % of the speed {}{}. "
      "{}Inertia {}.",
      dof,
      first.empty() ? "" : first + " Then ",
      ModelName(taken),
      score > kPoorFit ? ", though it fits poorly" : "",
      100.0 * score,
      on,
      std::isfinite(noise) ? fmt::format("; noise alone gives about {:.2g} %", 100.0 * noise) : "",
      as_good.empty() ? "" : fmt::format("As good within chance: {}. ", fmt::join(as_good, "; ")),
      WithInterval(taken.fitted.model.inertia,
                   std::sqrt(taken.fitted.covariance(kInertia, kInertia)),
                   UnitText(ParameterUnit(kInertia, comparison.dof, taken.fitted.force_unit)),
                   0.0,
                   std::numeric_limits<double>::infinity()));
}

// That the table marks; null where the best one is worse than a model that stands still.
const Identification* RowToTake(const DofComparison& comparison) {
  const Identification* const taken = Recommend(comparison).taken;
  const bool is_good = taken != nullptr && ScoreOf(comparison, *taken) < kScoreAtRest;
  return is_good ? taken : nullptr;
}

// What the mark of the row to take means.
std::string WhyTaken(const DofComparison& comparison) {
  const Recommendation recommendation = Recommend(comparison);
  const std::string of_nmae =
      fmt::format("{} NMAE (the error of the velocity, simulated from the command alone)",
                  comparison.HasHeldOut() ? "held-out" : "training");
  if (recommendation.least == nullptr) {
    return fmt::format("* the row to take: no other row has a lower {}", of_nmae);
  }
  return fmt::format("* the row to take: its parameters are known best. {} has a lower {}, but {}",
                     ModelName(*recommendation.least),
                     of_nmae,
                     recommendation.is_chance_known
                         ? "by no more than chance"
                         : "the data are too few to tell whether that is chance");
}

// The rows of a table with some of its columns.
Table WithColumns(const Table& table, const std::vector<size_t>& columns) {
  Table part;
  for (const size_t column : columns) part.columns.push_back(table.columns[column]);
  for (const TableRow& row : table.rows) {
    TableRow& line = part.rows.emplace_back();
    line.flag = row.flag;
    for (const size_t column : columns) line.cells.push_back(row.cells[column]);
  }
  return part;
}

// What decides, then the parameters; the other figures on demand. The section says which DOF it is.
std::vector<Table> TablesOf(const DofComparison& comparison) {
  const Table all = ParameterTable(comparison);
  const size_t held_out = all.columns.size() - 1, trained = held_out - 2;
  const size_t score = comparison.HasHeldOut() ? held_out : trained;
  Table shown = WithColumns(all, {1, score, 2, 3, 4, 5});
  Table others = WithColumns(all, {1, held_out, held_out - 1, trained, trained - 1});
  if (!comparison.HasHeldOut()) others = WithColumns(all, {1, trained, trained - 1});
  others.fold = comparison.HasHeldOut() ? "More figures: MAE, and errors on the training data"
                                        : "More figures: MAE";
  return {std::move(shown), std::move(others)};
}

PageSection SectionOf(const DofComparison& comparison) {
  PageSection section;
  section.heading = Capitalised(std::string(Name(comparison.dof)));
  for (const Finding& finding : comparison.findings) {
    if (finding.severity == Severity::kNote) section.notes.push_back(finding.sentence);
  }
  for (const std::string& remark : comparison.remarks) section.notes.push_back(remark);
  section.time_panels = {ResponsePanel(comparison), CommandPanel(comparison)};
  if (const Identification* taken = Recommend(comparison).taken) {
    section.folds = {RemainsFold(*taken, comparison.scored)};
  }
  section.parameter_panels = ParameterPanels(comparison);
  section.tables = TablesOf(comparison);

  Table notes;
  notes.caption = "What the intervals do not cover";
  notes.columns = {{"model"}, {"note"}};
  for (const Identification& row : comparison.rows) {
    if (!row.is_usable) notes.rows.push_back({{ModelName(row), row.message}, RowFlag::kUnusable});
    for (const std::string& caveat : row.fitted.caveats) {
      notes.rows.push_back({{ModelName(row), caveat}});
    }
  }
  if (!notes.rows.empty()) section.tables.push_back(notes);
  return section;
}

}  // namespace

std::vector<std::string> CommentsOn(const DofComparison& comparison) {
  std::vector<std::string> lines;
  if (RowToTake(comparison) != nullptr) lines.push_back(WhyTaken(comparison));
  if (const double noise = NoiseNmae(comparison); std::isfinite(noise)) {
    lines.push_back(
        fmt::format("noise alone (the scatter from sample to sample) gives a velocity NMAE of "
                    "about {:.2g}",
                    noise));
  }
  for (const Finding& finding : comparison.findings) {
    if (finding.severity == Severity::kNote) lines.push_back("note: " + finding.sentence);
  }
  for (const std::string& remark : comparison.remarks) lines.push_back("note: " + remark);
  for (const Identification& row : comparison.rows) {
    if (!row.is_usable) lines.push_back(fmt::format("! {}: {}", ModelName(row), row.message));
    for (const std::string& caveat : row.fitted.caveats) {
      lines.push_back(fmt::format("note: {}: {}", ModelName(row), caveat));
    }
  }
  return lines;
}

Table ParameterTable(const DofComparison& comparison) {
  const std::string& force_unit = comparison.scored.force_unit;
  const auto heading = [&](const char* name, int index) {
    return fmt::format("{} [{}]", name, UnitText(ParameterUnit(index, comparison.dof, force_unit)));
  };
  const std::string_view speed_unit = VelocityUnit(comparison.dof);
  // What decides stays: the held-out NMAE, or that of the training data where nothing is held out.
  const int train_rank = comparison.HasHeldOut() ? 3 : 0, held_out_rank = 3 - train_rank;
  Table table;
  table.columns = {{"DOF"},
                   {"model"},
                   {heading("inertia", kInertia), true},
                   {heading("q. damping", kQuadraticDamping), true},
                   {heading("l. damping", kLinearDamping), true, 1},
                   {heading("buoyancy", kBuoyancy), true, 2},
                   {fmt::format("training MAE [{}]", speed_unit), true, 4},
                   {"training NMAE", true, train_rank},
                   {"held-out MAE", true, 4},
                   {"held-out NMAE", true, held_out_rank}};
  const Identification* const taken = RowToTake(comparison);
  for (const Identification& row : comparison.rows) {
    TableRow line;
    line.cells = {std::string(Name(comparison.dof)), ModelName(row)};
    const ParameterVector values = ToVector(row.fitted.model);
    for (int i = 0; i < kNumParameters; ++i) {
      line.cells.push_back(FormatValue(row.is_usable ? values[i] : kNotKnown,
                                       std::sqrt(row.fitted.covariance(i, i))));
    }
    line.cells.push_back(Figure(row.fitted.train.mae, "{:.5f}"));
    line.cells.push_back(Figure(row.fitted.train.nmae, "{:.4f}"));
    line.cells.push_back(Figure(row.fitted.held_out.mae, "{:.5f}"));
    line.cells.push_back(Figure(row.fitted.held_out.nmae, "{:.4f}"));
    line.flag = !row.is_usable  ? RowFlag::kUnusable
                : &row == taken ? RowFlag::kBest
                                : RowFlag::kNone;
    table.rows.push_back(std::move(line));
  }
  return table;
}

Page ComparisonPage(const Comparison& comparison) {
  Page page;
  page.title = fmt::format("{}: models compared", comparison.log_name);
  page.subtitle =
      "Every identifier family on every source of this log, scored by simulating "
      "from the command alone";
  for (const DofComparison& dof : comparison.dofs) page.lead.push_back(Sentence(dof));
  for (const DofComparison& dof : comparison.dofs) {
    for (const Finding& finding : dof.findings) {
      if (finding.severity == Severity::kNote) continue;
      page.warnings.push_back(
          fmt::format("{}: {}", Capitalised(std::string(Name(dof.dof))), finding.sentence));
    }
  }
  for (const DofComparison& dof : comparison.dofs) {
    const auto duration = [](const std::vector<Segment>& segments) {
      double sum = 0.0;
      for (const Segment& segment : segments) sum += segment.time.back() - segment.time.front();
      return sum;
    };
    page.facts.push_back({std::string(Name(dof.dof)),
                          fmt::format("{:.0f} s training data, {:.0f} s held out",
                                      duration(dof.scored.train),
                                      duration(dof.scored.held_out))});
    page.sections.push_back(SectionOf(dof));
  }
  // Of the whole log: no warnings.
  if (!page.sections.empty()) {
    std::vector<std::string>& notes = page.sections.front().notes;
    notes.insert(notes.begin(), comparison.remarks.begin(), comparison.remarks.end());
  }
  page.footer =
      "MAE and NMAE are errors of the velocity when simulating from the command alone, "
      "started "
      "where the model fits the first two seconds of each segment best (docs/models.md). In the "
      "table, ± is one "
      "standard deviation, and the row in bold is the one to take. Bars and the sentences above "
      "give 95 % intervals.";
  return page;
}

}  // namespace fathom
