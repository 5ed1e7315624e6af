// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/ordinary_page.h"

#include "fathom/ordinary_dives/ordinary_text.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kAllRows = std::numeric_limits<std::size_t>::max();

// The speed of a log, with the chosen stretches in colour. Between two segments the line stops.
TimePanel SpeedPanel(const OrdinaryRequest& request,
                     const OrdinaryDives& dives,
                     std::size_t log_index) {
  TimePanel panel;
  panel.quantity = fmt::format("{} velocity", Name(request.model.dof));
  panel.unit = VelocityUnit(request.model.dof);
  panel.has_residuals = false;
  const double first = FirstStamp(request, log_index);
  Series& measured = panel.measured.emplace();
  measured.name = "measured";
  for (std::size_t s = 0; s < request.segments.size(); ++s) {
    if (request.log_of_segment[s] != log_index) continue;
    const Segment& segment = request.segments[s];
    if (!panel.time.empty()) {
      panel.time.push_back(segment.time.front() - first);
      measured.values.push_back(kGap);
    }
    for (std::size_t i = 0; i < segment.time.size(); ++i) {
      panel.time.push_back(segment.time[i] - first);
      measured.values.push_back(segment.velocity[i]);
    }
  }
  for (const std::size_t k : dives.chosen) {
    const OrdinaryStretch& stretch = dives.stretches[k];
    if (stretch.log_index != log_index) continue;
    Series& chosen = panel.responses.emplace_back();
    chosen.name = fmt::format("{} choice", PlaceName(stretch.place));
    for (std::size_t i = 0; i < panel.time.size(); ++i) {
      const bool is_in = stretch.time.Contains(panel.time[i] + first);
      chosen.values.push_back(is_in ? measured.values[i] : kGap);
    }
  }
  return panel;
}

TimePanel ForcePanel(const OrdinaryRequest& request,
                     const TimePanel& speed,
                     std::size_t log_index) {
  TimePanel panel;
  panel.quantity = fmt::format("{} command", Name(request.model.dof));
  panel.unit = request.model.force_unit;
  panel.time = speed.time;
  panel.has_residuals = false;
  panel.is_stepped = true;
  panel.is_low = true;
  Series& force = panel.responses.emplace_back();
  force.name = "commanded";
  for (std::size_t s = 0; s < request.segments.size(); ++s) {
    if (request.log_of_segment[s] != log_index) continue;
    if (!force.values.empty()) force.values.push_back(kGap);
    const Segment& segment = request.segments[s];
    const std::vector<double> values = segment.command.At(segment.time);
    force.values.insert(force.values.end(), values.begin(), values.end());
  }
  return panel;
}

// No line ends within "± 13 %".
std::string KeptTogether(std::string text) {
  const std::string no_break = "\u00a0";
  for (const auto& [beside, space] : {std::pair<std::string, std::size_t>{"± ", 2}, {" %", 0}}) {
    for (std::size_t at = text.find(beside); at != std::string::npos; at = text.find(beside, at)) {
      text.replace(at + space, 1, no_break);
    }
  }
  return text;
}

}  // namespace

Page OrdinaryPage(const OrdinaryRequest& request, const OrdinaryDives& dives) {
  const Dof dof = request.model.dof;
  Page page;
  page.title = fmt::format("Which ordinary dives do: {}", Name(dof));
  page.subtitle = fmt::format("judged by {}", request.name);
  page.lead = {KeptTogether(OrdinarySentence(request, dives))};
  for (std::string& sentence : OrdinaryRemedySentences(dives)) {
    page.lead.push_back(KeptTogether(std::move(sentence)));
  }
  double length = 0.0;
  for (const std::size_t k : dives.chosen) length += dives.stretches[k].Length();
  page.facts = {{"Logs", fmt::format("{}", request.logs.size())},
                {"Length of all", fmt::format("{:.0f} s", dives.duration)},
                {"Stretches", fmt::format("{}", dives.stretches.size())},
                {"Chosen stretches", fmt::format("{}", dives.chosen.size())},
                {"Their length", fmt::format("{:.0f} s", length)}};
  PageSection& tables = page.sections.emplace_back();
  tables.heading = "What the stretches tell";
  tables.tables = {ChosenStretchTable(request, dives)};
  Table alone = LoneStretchTable(request, dives, kAllRows);
  alone.fold = fmt::format("Each of the {} stretches alone", dives.stretches.size());
  tables.tables.push_back(std::move(alone));
  if (std::vector<std::string> commands = HowToFitChosen(request, dives); !commands.empty()) {
    tables.folds.push_back({"How to fit the chosen stretches alone", std::move(commands)});
  }
  tables.notes = OrdinaryComments(request, dives);
  for (std::size_t k = 0; k < request.logs.size(); ++k) {
    if (!IsChosenFrom(dives, k)) continue;
    PageSection& section = page.sections.emplace_back();
    section.heading = ShownLogNames(request)[k];
    TimePanel speed = SpeedPanel(request, dives, k);
    TimePanel force = ForcePanel(request, speed, k);
    section.time_panels = {std::move(speed), std::move(force)};
  }
  page.footer =
      "Half 95 % intervals in shares of the parameter, predicted from the model of these logs: the "
      "better it is, the better they are. Time counts from each log's first sample. docs/plan.md.";
  return page;
}

}  // namespace fathom
