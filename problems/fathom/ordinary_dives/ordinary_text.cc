// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/ordinary_text.h"

#include "fathom/base/interval95.h"
#include "fathom/base/plural.h"
#include "fathom/base/shell_word.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kMuchWider = 2.0;      // of the fit, against the forecast
constexpr double kNothingKnown = 10.0;  // half an interval by size

// "± 13 %"; "open" where it says nothing.
std::string ShareOfSize(double share) {
  if (!(share < kNothingKnown)) return "open";
  const double percent = 100.0 * share;
  return fmt::format("± {} %", RoundedAt(percent, std::max(0, DecimalsFor(percent))));
}

std::string ShareOf(const OrdinaryDives& dives, const OrdinaryKnowledge& knowledge, std::size_t i) {
  return ShareOfSize(kStdsOf95 * knowledge.stds[i] / dives.parameters[i].size);
}

// "23 s", "4.1 min".
std::string LengthText(double seconds) {
  return seconds < 100.0 ? fmt::format("{:.0f} s", seconds)
                         : fmt::format("{:.1f} min", seconds / 60.0);
}

double LengthOfChosen(const OrdinaryDives& dives) {
  double length = 0.0;
  for (const std::size_t k : dives.chosen) length += dives.stretches[k].Length();
  return length;
}

// "dive_2, 51 to 110 s"; without the log where there is one alone.
std::string WhereText(const OrdinaryRequest& request, const OrdinaryStretch& stretch) {
  const std::string time = fmt::format("{:.0f} to {:.0f} s",
                                       TimeInLog(request, stretch, stretch.time.from),
                                       TimeInLog(request, stretch, stretch.time.to));
  if (request.logs.size() < 2) return time;
  return ShownLogNames(request)[stretch.log_index] + ", " + time;
}

void AddParameterColumns(const OrdinaryDives& dives, Table* table) {
  for (const OrdinaryParameter& parameter : dives.parameters) {
    table->columns.push_back({parameter.name, true});
  }
}

void AddShares(const OrdinaryDives& dives, const OrdinaryKnowledge& knowledge, TableRow* row) {
  for (std::size_t i = 0; i < dives.parameters.size(); ++i) {
    row->cells.push_back(ShareOf(dives, knowledge, i));
  }
}

// What of a log lies outside of the chosen stretches, held-out data with it.
std::vector<TimeInterval> RestOfLog(const OrdinaryRequest& request,
                                    const OrdinaryDives& dives,
                                    std::size_t log_index) {
  constexpr double kHundredth = 0.01;  // [s], as times are printed
  const TimeInterval& span = request.spans[log_index];
  std::vector<TimeInterval> rest;
  double from = span.from;
  for (const OrdinaryStretch& stretch : dives.stretches) {
    if (stretch.log_index != log_index || stretch.place == 0) continue;
    if (stretch.time.from - from >= kHundredth) rest.push_back({from, stretch.time.from});
    from = stretch.time.to;
  }
  if (from < span.to) rest.push_back({from, span.to + kHundredth});
  return rest;
}

// "linear_damping ± 60 % and buoyancy ± 80 %": what is wider than this.
std::vector<std::string> Wider(const OrdinaryDives& dives, double share) {
  std::vector<std::string> wider;
  for (std::size_t i = 0; i < dives.parameters.size(); ++i) {
    if (!(kStdsOf95 * dives.all.stds[i] / dives.parameters[i].size > share)) continue;
    wider.push_back(fmt::format("{} ({})", dives.parameters[i].name, ShareOf(dives, dives.all, i)));
  }
  return wider;
}

}  // namespace

std::vector<std::string> ShownLogNames(const OrdinaryRequest& request) {
  std::vector<std::string> names;
  for (const std::string& log : request.logs) {
    const std::filesystem::path path = std::filesystem::path(log).lexically_normal();
    names.push_back((path.has_filename() ? path : path.parent_path()).filename().string());
  }
  std::vector<std::string> sorted = names;
  std::ranges::sort(sorted);
  const bool are_different = std::ranges::adjacent_find(sorted) == sorted.end();
  return are_different ? names : request.logs;
}

std::string PlaceName(int place) {
  const int last = place % 10;
  const bool is_teen = place / 10 % 10 == 1;
  if (last == 1 && !is_teen) return fmt::format("{}st", place);
  if (last == 2 && !is_teen) return fmt::format("{}nd", place);
  if (last == 3 && !is_teen) return fmt::format("{}rd", place);
  return fmt::format("{}th", place);
}

bool IsChosenFrom(const OrdinaryDives& dives, std::size_t log_index) {
  return std::ranges::any_of(
      dives.chosen, [&](std::size_t k) { return dives.stretches[k].log_index == log_index; });
}

double FirstStamp(const OrdinaryRequest& request, std::size_t log_index) {
  for (std::size_t s = 0; s < request.segments.size(); ++s) {
    if (request.log_of_segment[s] == log_index) return request.segments[s].time.front();
  }
  return 0.0;
}

double TimeInLog(const OrdinaryRequest& request, const OrdinaryStretch& stretch, double time) {
  return time - FirstStamp(request, stretch.log_index);
}

std::string OrdinarySentence(const OrdinaryRequest& request, const OrdinaryDives& dives) {
  if (!dives.IsUsable()) return dives.message;
  const OrdinaryKnowledge& chosen = dives.stretches[dives.chosen.back()].together;
  std::vector<std::string> where;
  for (const std::size_t k : dives.chosen) where.push_back(WhereText(request, dives.stretches[k]));
  const std::string& name = dives.parameters[chosen.weakest].name;
  std::string text = fmt::format(
      "Of {} of {}, {} of {} tell{} {}: {}. The widest interval is then that of {}, {}; by all "
      "logs {}{}.",
      LengthText(dives.duration),
      Name(request.model.dof),
      Plural(dives.chosen.size(), "part"),
      LengthText(LengthOfChosen(dives)),
      dives.chosen.size() == 1 ? "s" : "",
      dives.DoesAsWellAsAll(chosen) ? "about as much as all" : "most",
      fmt::join(where, request.logs.size() < 2 ? ", " : "; "),
      name,
      ShareOfSize(chosen.share),
      chosen.weakest == dives.all.weakest
          ? std::string()
          : fmt::format("that of {}, ", dives.parameters[dives.all.weakest].name),
      ShareOfSize(dives.all.share));
  const std::vector<std::string> open = Wider(dives, OrdinaryDives::kOpen);
  if (!open.empty()) {
    return text + fmt::format(" Even by all logs {} stay{} open.",
                              fmt::join(open, " and "),
                              open.size() == 1 ? "s" : "");
  }
  const std::vector<std::string> rough = Wider(dives, OrdinaryDives::kWellKnown);
  if (rough.empty()) return text + " Nothing stays open: dives like these will do.";
  return text + fmt::format(" Nothing stays open, but {} {} known roughly.",
                            fmt::join(rough, " and "),
                            rough.size() == 1 ? "is" : "are");
}

std::vector<std::string> OrdinaryRemedySentences(const OrdinaryDives& dives) {
  std::vector<std::string> sentences;
  if (dives.all.share <= OrdinaryDives::kWellKnown) return sentences;
  const std::string& weakest = dives.parameters[dives.all.weakest].name;
  for (const Remedy& remedy : dives.remedies) {
    sentences.push_back(fmt::format("For {}, {}: {} instead of {}.",
                                    weakest,
                                    remedy.words,
                                    ShareOfSize(remedy.share),
                                    ShareOfSize(dives.all.share)));
    if (remedy.minutes < 2) continue;
    sentences.back() += fmt::format(" After {} such minutes it is known to {} or better.",
                                    remedy.minutes,
                                    ShareOfSize(OrdinaryDives::kWellKnown));
  }
  if (dives.neighbour_correlation >= OrdinaryDives::kAlike) {
    sentences.push_back(fmt::format(
        "A faster rate tells little: neighbouring samples err alike (correlation {:.2f}), by what "
        "the model lacks, a filter or the sensor. fathom_diagnose says whether the model lacks "
        "something.{}",
        dives.neighbour_correlation,
        dives.is_position ? ""
                          : " If it is the sensor, record the position too, as by a camera and "
                            "markers."));
  }
  return sentences;
}

std::vector<std::string> HowToFitChosen(const OrdinaryRequest& request,
                                        const OrdinaryDives& dives) {
  std::vector<std::string> lines;
  std::string logs;
  const auto joined = [&](std::size_t log_index, std::string_view form, std::string_view between) {
    std::vector<std::string> texts;
    for (const TimeInterval& rest : RestOfLog(request, dives, log_index)) {
      texts.push_back(fmt::format(fmt::runtime(form), rest.from, rest.to));
    }
    return fmt::format("{}", fmt::join(texts, between));
  };
  for (std::size_t k = 0; k < request.logs.size(); ++k) {
    if (!IsChosenFrom(dives, k)) continue;
    logs += " --log=" + ShellWord(request.logs[k]);
    if (request.logs.size() == 1) continue;
    const std::string rest = joined(k, "[{:.2f}, {:.2f}]", ", ");
    if (!rest.empty()) {
      lines.push_back(fmt::format("held_out: [{}] in the log.yaml of {}", rest, request.logs[k]));
    }
  }
  std::string command = fmt::format(
      "fathom_identify{}{} --dof={}", logs, request.data_flags, Name(request.model.dof));
  if (request.logs.size() == 1) {
    const std::string rest = joined(0, "{:.2f}:{:.2f}", ",");
    if (rest.empty()) return {};
    command += " --held_out=" + rest;
  }
  lines.push_back(std::move(command));
  return lines;
}

std::vector<std::string> OrdinaryComments(const OrdinaryRequest& request,
                                          const OrdinaryDives& dives) {
  const Dof dof = request.model.dof;
  std::vector<std::string> comments = {
      fmt::format(
          "The intervals are those of fits to {}, with what the model's runs miss as noise: "
          "{:.2g} {} at {:.3g} Hz, correlation of neighbours {:.2f}.",
          dives.is_position ? "displacements" : "velocities",
          dives.noise,
          dives.is_position ? DisplacementUnit(dof) : VelocityUnit(dof),
          dives.rate,
          dives.neighbour_correlation),
      "Shares are of the parameter; of the buoyancy, of the greatest force; of a damping, of a "
      "hundredth of the greatest force at least."};
  for (const OrdinaryParameter& parameter : dives.parameters) {
    if (request.logs.size() < 2 || !(parameter.by_fit > kMuchWider * parameter.by_all)) continue;
    comments.push_back(
        fmt::format("The model holds {} {:.1f} times less exactly than the noise alone would leave "
                    "it: the logs disagree. Fit them one by one to see which.",
                    parameter.name,
                    parameter.by_fit / parameter.by_all));
  }
  return comments;
}

Table ChosenStretchTable(const OrdinaryRequest& request, const OrdinaryDives& dives) {
  Table table = {
      .caption = "Stretches that do: half 95 % intervals; each row counts those above it too",
      .columns = {{"choice"}, {"stretch"}},
      .rows = {}};
  AddParameterColumns(dives, &table);
  for (const std::size_t k : dives.chosen) {
    const OrdinaryStretch& stretch = dives.stretches[k];
    TableRow& row = table.rows.emplace_back();
    row.cells = {PlaceName(stretch.place), WhereText(request, stretch)};
    AddShares(dives, stretch.together, &row);
  }
  TableRow& all = table.rows.emplace_back();
  all.cells = {"all logs", LengthText(dives.duration)};
  AddShares(dives, dives.all, &all);
  return table;
}

Table LoneStretchTable(const OrdinaryRequest& request,
                       const OrdinaryDives& dives,
                       std::size_t most_rows) {
  std::vector<const OrdinaryStretch*> best_first;
  for (const OrdinaryStretch& stretch : dives.stretches) best_first.push_back(&stretch);
  std::ranges::stable_sort(
      best_first, {}, [](const OrdinaryStretch* stretch) { return stretch->alone.share; });
  const std::size_t num_rows = std::min(most_rows, best_first.size());
  Table table = {
      .caption =
          num_rows < best_first.size()
              ? fmt::format("Each stretch alone, the best {} of {}", num_rows, best_first.size())
              : "Each stretch alone, best first",
      .columns = {{"stretch"}},
      .rows = {}};
  AddParameterColumns(dives, &table);
  for (std::size_t k = 0; k < num_rows; ++k) {
    TableRow& row = table.rows.emplace_back();
    row.cells = {WhereText(request, *best_first[k])};
    AddShares(dives, best_first[k]->alone, &row);
  }
  return table;
}

}  // namespace fathom
