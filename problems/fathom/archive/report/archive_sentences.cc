// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/archive_sentences.h"

#include "fathom/archive/dives/named_few.h"
#include "fathom/archive/report/dives_apart.h"
#include "fathom/archive/report/log_states.h"
#include "fathom/archive/store/compared_dofs.h"
#include "fathom/base/dof.h"
#include "fathom/base/plural.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// By vehicle, the dives with a usable joint fit of that DOF which has most of them.
std::map<std::string, std::size_t> NumDivesCompared(const Tables& tables) {
  std::map<std::pair<std::string, std::string>, std::set<std::string>> dives;
  for (const DiveFitRow& row : tables.dive_fits) {
    auto& of_dof = dives[{row.vehicle, row.dof}];
    if (row.usable && std::isfinite(row.value)) of_dof.insert(row.dive);
  }
  std::map<std::string, std::size_t> counts;
  for (const auto& [key, of_dof] : dives) {
    std::size_t& count = counts[key.first];
    count = std::max(count, of_dof.size());
  }
  return counts;
}

// Vehicles of which too few dives say something, each in a sentence of its own.
constexpr std::size_t kMostToldApart = 2;

std::string QuietSentence(const std::string& vehicle, std::size_t num_dives, bool is_apart) {
  const std::string of = vehicle.empty() ? "" : " of " + vehicle;
  if (num_dives >= kFewestDivesForChange) {
    return is_apart ? fmt::format("No step or trend explains it over {} dives{}.", num_dives, of)
                    : fmt::format("No change over {} dives{}.", num_dives, of);
  }
  if (num_dives == 0) {
    return fmt::format("No statement on change{}: no dive has a usable joint fit.", of);
  }
  return fmt::format(
      "No statement on change{}: only {} {} a usable joint fit, at least {} are "
      "needed.",
      of,
      Plural(num_dives, "dive"),
      num_dives == 1 ? "has" : "have",
      kFewestDivesForChange);
}

// By state, how many logs have a red finding.
std::map<std::string, std::size_t> RedByState(const Tables& tables) {
  std::set<std::string> red;
  for (const FindingRow& finding : tables.findings) {
    if (finding.severity == "red") red.insert(finding.log);
  }
  std::map<std::string, std::size_t> counts;
  for (const LogRow& log : tables.logs) {
    if (red.contains(log.path)) ++counts[log.status];
  }
  return counts;
}

// "950 ok, 2 of them with red findings; 30 partial": the states of `counts` that do or do not give
// a model, known ones first. `red`: of those that do.
std::string Listed(const std::map<std::string, std::size_t>& counts,
                   bool gives_model,
                   const std::map<std::string, std::size_t>& red) {
  std::vector<std::string> names = StatesInOrder();
  for (const auto& [state, count] : counts) {
    if (std::ranges::find(names, state) == names.end()) names.push_back(state);
  }
  std::vector<std::string> parts;
  bool is_long = false;
  for (const std::string& name : names) {
    const auto found = counts.find(name);
    if (found == counts.end() || GivesModel(name) != gives_model) continue;
    parts.push_back(fmt::format("{} {}", found->second, StateText(name)));
    const auto of_them = red.find(name);
    if (!gives_model || of_them == red.end()) continue;
    parts.back() += fmt::format(", {} of them with red findings", of_them->second);
    is_long = true;
  }
  return fmt::format("{}", fmt::join(parts, is_long ? "; " : ", "));
}

std::string OtherFiles(const std::map<std::string, int>& files) {
  if (files.empty()) return "";
  std::vector<std::string> kinds;
  std::size_t sum = 0;
  for (const auto& [ending, count] : files) {
    kinds.push_back(fmt::format("{} {}", count, ending.empty() ? "without an ending" : ending));
    sum += static_cast<std::size_t>(count);
  }
  return fmt::format(" {} no {}: {}.",
                     Plural(sum, "other file") + (sum == 1 ? " is" : " are"),
                     sum == 1 ? "log" : "logs",
                     fmt::join(kinds, ", "));
}

// By log and DOF the NMAE of the best model, on held-out data where there are any.
std::map<std::pair<std::string, std::string>, double> BestNmaes(const Tables& tables) {
  std::map<std::pair<std::string, std::string>, double> best;
  for (const ScoreRow& row : tables.scores) {
    const double nmae = std::isfinite(row.heldout_nmae) ? row.heldout_nmae : row.nmae;
    if (!std::isfinite(nmae)) continue;
    double& least = best.try_emplace({row.log, row.dof}, nmae).first->second;
    least = std::min(least, nmae);
  }
  return best;
}

// What to think of the changes where many models are poor; empty where few are.
std::string PoorModelsSentence(const Tables& tables) {
  constexpr double kPoor = 0.5;        // misses half of the motion
  constexpr double kManyOfAll = 0.25;  // of the models
  const auto best = BestNmaes(tables);
  const auto num_poor = static_cast<std::size_t>(
      std::ranges::count_if(best, [](const auto& entry) { return entry.second > kPoor; }));
  if (num_poor == 0 || static_cast<double>(num_poor) < kManyOfAll * best.size()) return "";
  return fmt::format(
      "{} of {} models of single logs miss over half of the motion (NMAE above {}): changes can "
      "hide "
      "behind that.",
      num_poor,
      best.size(),
      kPoor);
}

// Each text once, those with the least p-value first.
std::vector<std::string> TextsOf(const std::vector<ChangeRow>& changes) {
  std::map<std::string, double> p_values;
  for (const ChangeRow& row : changes) {
    double& least = p_values.try_emplace(row.text, 1.0).first->second;
    if (row.p_value < least) least = row.p_value;
  }
  std::vector<std::string> texts;
  for (const auto& [text, p_value] : p_values) texts.push_back(text);
  std::stable_sort(texts.begin(), texts.end(), [&](const std::string& a, const std::string& b) {
    return p_values[a] < p_values[b];
  });
  return texts;
}

std::vector<std::string> SentencesOfVehicles(const Tables& tables) {
  std::vector<std::string> sentences = TextsOf(tables.changes);
  const auto compared = NumDivesCompared(tables);
  if (compared.size() <= 1) {
    const std::size_t num_dives = compared.empty() ? 0 : compared.begin()->second;
    const std::string apart =
        DivesApartSentence(tables, compared.empty() ? "" : compared.begin()->first);
    if (sentences.empty()) sentences.push_back(QuietSentence("", num_dives, !apart.empty()));
    if (!apart.empty()) sentences.insert(sentences.begin(), apart);
    return sentences;
  }
  std::set<std::string> changed;
  for (const ChangeRow& row : tables.changes) changed.insert(row.vehicle);
  std::vector<std::string> of_few_dives;
  for (const auto& [vehicle, num_dives] : compared) {
    if (changed.contains(vehicle)) continue;
    auto& list = num_dives < kFewestDivesForChange ? of_few_dives : sentences;
    const std::string name = vehicle.empty() ? "the vehicle without a name" : vehicle;
    const std::string apart = DivesApartSentence(tables, vehicle);
    if (!apart.empty()) list.push_back(fmt::format("Of {}: {}", name, apart));
    list.push_back(QuietSentence(name, num_dives, !apart.empty()));
  }
  if (of_few_dives.size() > kMostToldApart) {
    sentences.push_back(
        fmt::format("No statement on change of {} vehicles: fewer than {} dives of each have a "
                    "usable joint fit.",
                    of_few_dives.size(),
                    kFewestDivesForChange));
  } else {
    sentences.insert(sentences.end(), of_few_dives.begin(), of_few_dives.end());
  }
  return sentences;
}

}  // namespace

std::vector<std::string> ChangeSentences(const Tables& tables) {
  std::vector<std::string> sentences = SentencesOfVehicles(tables);
  if (std::string poor = PoorModelsSentence(tables); !poor.empty()) {
    sentences.push_back(std::move(poor));
  }
  return sentences;
}

std::string DivesWithoutFitSentence(const Tables& tables) {
  std::set<std::string> dives, with_model, with_fit;
  std::map<std::string, const DiveFitRow*> first_refused;
  for (const LogRow& log : tables.logs) {
    dives.insert(log.dive);
    if (GivesModel(log.status)) with_model.insert(log.dive);
  }
  for (const DiveFitRow& row : tables.dive_fits) {
    dives.insert(row.dive);
    if (row.usable) {
      with_fit.insert(row.dive);
    } else if (!row.message.empty()) {
      first_refused.emplace(row.dive, &row);
    }
  }
  dives.erase("");
  std::vector<std::string> without;
  for (const std::string& dive : dives) {
    if (with_fit.contains(dive)) continue;
    const auto refused = first_refused.find(dive);
    std::string why = "no fit was made";
    if (refused != first_refused.end()) {
      why = fmt::format("{}: {}", refused->second->dof, refused->second->message);
      if (why.ends_with('.')) why.pop_back();
    } else if (!with_model.contains(dive)) {
      why = "no log of it gave a model";
    }
    without.push_back(fmt::format("{} ({})", dive, why));
  }
  if (without.empty()) return "";
  return fmt::format("Of {} no DOF has a usable joint fit: {}.",
                     Plural(without.size(), "dive"),
                     NamedFew(without));
}

std::string LeftOutSentence(const Tables& tables) {
  std::map<std::string, std::pair<std::size_t, const FindingRow*>> left_out;
  for (const FindingRow& row : tables.findings) {
    if (row.id != kLeftOutOfCoupled) continue;
    auto& [count, first] = left_out[row.dof];
    if (count++ == 0) first = &row;
  }
  std::vector<std::string> parts;
  for (const Dof dof : kAllDofs) {
    const auto found = left_out.find(std::string(Name(dof)));
    if (found == left_out.end()) continue;
    const auto& [count, first] = found->second;
    std::string why = first->text;
    if (why.ends_with('.')) why.pop_back();
    parts.push_back(
        count == 1
            ? fmt::format("{} ({}: {})", found->first, first->log, why)
            : fmt::format(
                  "{} ({}, as {}: {})", found->first, Plural(count, "log"), first->log, why));
  }
  if (parts.empty()) return "";
  return fmt::format(
      "Left out of the coupled models, though the vehicle moves so: {}. --dofs=DOF,... "
      "models what it names.",
      fmt::join(parts, ", "));
}

std::string CoupledSentence(const Tables& tables) {
  std::map<std::string, std::size_t> verdicts, named;
  std::size_t num_models = 0;
  for (const VerdictRow& row : tables.verdicts) {
    if (!IsOfSeveralDofs(row.dof)) continue;
    ++num_models;
    ++verdicts[row.verdict];
  }
  if (num_models == 0) return "";
  for (const CauseRow& row : tables.causes) {
    if (IsOfSeveralDofs(row.dof)) ++named[row.parameter];
  }
  std::vector<std::string> counts, names;
  for (const auto& [verdict, count] : verdicts) {
    counts.push_back(fmt::format("{} {}", count, verdict));
  }
  for (const auto& [entry, count] : named) {
    names.push_back(fmt::format("{} ({})", entry, Plural(count, "log")));
  }
  std::string text =
      fmt::format("{}: {}.", Plural(num_models, "coupled model"), fmt::join(counts, ", "));
  if (!names.empty()) {
    text +=
        fmt::format(" {} {}.", num_models == 1 ? "It names" : "They name", fmt::join(names, ", "));
  }
  const bool are_compared = std::ranges::any_of(tables.dive_fits, [&](const DiveFitRow& row) {
    return IsOfSeveralDofs(row.dof) &&
           CoupledDofsCompared(tables.dive_fits, row.vehicle) == row.dof;
  });
  return are_compared ? text + " Changes along their DOFs are told from one coupled model a dive."
                      : text;
}

std::string LogsSentence(const ArchiveReport& report) {
  std::map<std::string, std::size_t> counts;
  std::set<std::string> dives(report.dives.begin(), report.dives.end());
  std::size_t num_models = 0;
  for (const LogRow& log : report.tables.logs) {
    ++counts[log.status];
    num_models += GivesModel(log.status) ? 1 : 0;
    if (!log.dive.empty()) dives.insert(log.dive);
  }
  const std::size_t num_logs = report.tables.logs.size();
  if (num_logs == 0) return "There are no logs." + OtherFiles(report.other_files);

  std::string text =
      fmt::format("{} in {}: ", Plural(num_logs, "log"), Plural(dives.size(), "dive"));
  const std::map<std::string, std::size_t> red = RedByState(report.tables);
  text += num_models == 0
              ? "none gave a model"
              : fmt::format("{} gave a model ({})", num_models, Listed(counts, true, red));
  if (num_models < num_logs) {
    text += fmt::format(", {} did not ({})", num_logs - num_models, Listed(counts, false, red));
  }
  return text + "." + OtherFiles(report.other_files);
}

}  // namespace fathom
