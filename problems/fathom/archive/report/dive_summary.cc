// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/dive_summary.h"

#include "fathom/archive/report/log_states.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace fathom {
namespace {

using LogAndDof = std::pair<std::string, std::string>;

// The summaries while they are made, and the way from a log to that of its dive.
class Book {
 public:
  explicit Book(const ArchiveReport& report) {
    for (const std::string& dive : report.dives) Add(dive);
    const std::vector<LogRow>& logs = report.tables.logs;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      dive_of_log_[logs[i].path] = logs[i].dive;
      DiveSummary& summary = Add(logs[i].dive);
      summary.logs.push_back(i);
      summary.num_without_model += GivesModel(logs[i].status) ? 0 : 1;
      const std::string& start = logs[i].start;
      if (!start.empty() && (summary.start.empty() || start < summary.start)) summary.start = start;
    }
  }

  DiveSummary& Add(const std::string& dive) {
    const auto [found, is_new] = place_of_dive_.try_emplace(dive, summaries.size());
    if (is_new) summaries.emplace_back().dive = dive;
    return summaries[found->second];
  }

  // Null for a log that is not in the table of logs.
  DiveSummary* OfLog(const std::string& log) {
    const auto found = dive_of_log_.find(log);
    return found == dive_of_log_.end() ? nullptr : &Add(found->second);
  }

  std::vector<DiveSummary> summaries;

 private:
  std::map<std::string, std::size_t> place_of_dive_;
  std::map<std::string, std::string> dive_of_log_;
};

// The larger number; NaN only if both are.
double Worse(double a, double b) { return std::fmax(a, b); }

void AddModels(const Tables& tables, Book* book) {
  for (const FitRow& row : tables.fits) {
    if (row.family == kCoupledFamily) continue;  // they have a table of their own
    DiveSummary* const summary = book->OfLog(row.log);
    if (summary != nullptr && row.usable) summary->dofs[row.dof].has_model = true;
  }
  for (const DiveFitRow& row : tables.dive_fits) {
    if (row.usable) book->Add(row.dive).dofs[row.dof].has_model = true;
  }
}

void AddScores(const Tables& tables, Book* book) {
  std::map<LogAndDof, double> best;
  for (const ScoreRow& row : tables.scores) {
    double& score = best.try_emplace({row.log, row.dof}, kNoNumber).first->second;
    score = std::fmin(score, row.heldout_nmae);
  }
  for (const auto& [key, score] : best) {
    DiveSummary* const summary = book->OfLog(key.first);
    if (summary == nullptr) continue;
    double& worst = summary->dofs[key.second].heldout_nmae;
    worst = Worse(worst, score);
  }
  for (const PredictionRow& row : tables.predictions) {
    DiveSummary* const summary = book->OfLog(row.log);
    if (summary == nullptr) continue;
    double& worst = summary->dofs[row.dof].prediction_nmae;
    worst = Worse(worst, row.nmae);
  }
}

void AddDiagnoses(const Tables& tables, Book* book) {
  for (const VerdictRow& row : tables.verdicts) {
    DiveSummary* const summary = book->OfLog(row.log);
    if (summary != nullptr) ++summary->dofs[row.dof].verdicts[row.verdict];
  }
  // An effect has a row for each of its parameters.
  std::set<std::tuple<std::string, std::string, std::string>> named;
  for (const CauseRow& row : tables.causes) {
    if (!named.emplace(row.log, row.dof, row.effect).second) continue;
    DiveSummary* const summary = book->OfLog(row.log);
    if (summary != nullptr) ++summary->dofs[row.dof].causes[row.effect];
  }
}

void AddFindings(const Tables& tables, Book* book) {
  for (const FindingRow& row : tables.findings) {
    DiveSummary* const summary = book->OfLog(row.log);
    if (summary != nullptr) ++(row.severity == "red" ? summary->num_red : summary->num_yellow);
  }
}

}  // namespace

double DiveSummary::HeldOutNmae() const {
  double worst = kNoNumber;
  for (const auto& [name, dof] : dofs) worst = Worse(worst, dof.heldout_nmae);
  return worst;
}

std::vector<DiveSummary> SummariesOf(const ArchiveReport& report) {
  Book book(report);
  AddModels(report.tables, &book);
  AddScores(report.tables, &book);
  AddDiagnoses(report.tables, &book);
  AddFindings(report.tables, &book);
  return std::move(book.summaries);
}

std::vector<std::size_t> WorstFirst(const std::vector<DiveSummary>& summaries) {
  const auto badness = [&](std::size_t place) {
    const DiveSummary& summary = summaries[place];
    const double score = summary.HeldOutNmae();
    return std::tuple(summary.num_without_model, summary.num_red, std::isnan(score) ? -1.0 : score);
  };
  std::vector<std::size_t> places(summaries.size());
  std::iota(places.begin(), places.end(), 0);
  std::ranges::stable_sort(places, std::greater<>(), badness);
  return places;
}

}  // namespace fathom
