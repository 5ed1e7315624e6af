// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/follow_page.h"

#include "fathom/adaptive/usable_estimate.h"
#include "fathom/base/plural.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kZOf95 = 1.96;

std::string UnitOfParameter(int index, Dof dof) {
  return ParameterUnit(index, dof, std::string(ForceUnit(dof)));
}

std::string NameOfParameter(int index) {
  std::string name(kParameterInfo[static_cast<std::size_t>(index)].name);
  for (char& c : name) {
    if (c == '_') c = ' ';
  }
  return name;
}

// The start of a pass, where the law is still far off, would hide all that comes after it.
std::vector<FollowedEstimate> BehindTheStart(const std::vector<FollowedEstimate>& estimates) {
  const auto start = static_cast<std::ptrdiff_t>(estimates.size() / 10);
  return {estimates.begin() + start, estimates.end()};
}

TimePanel PanelOf(const std::vector<FollowedEstimate>& estimates, int index, Dof dof) {
  TimePanel panel;
  panel.quantity = NameOfParameter(index);
  panel.unit = UnitOfParameter(index, dof);
  panel.has_residuals = false;
  Series series = {
      .name = "estimate", .values = {}, .note = "band: 1.96 times the scatter; gap: not usable"};
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  for (const FollowedEstimate& estimate : estimates) {
    panel.time.push_back(estimate.t);
    series.values.push_back(estimate.usable ? ToVector(estimate.model)[index] : kGap);
    series.half_width.push_back(estimate.usable ? kZOf95 * estimate.std[index] : kGap);
  }
  panel.responses.push_back(std::move(series));
  return panel;
}

Fact LastOf(const FollowedEstimate& last, int index, Dof dof) {
  return {NameOfParameter(index),
          fmt::format("{:.5g}{}{:.2g} {}",
                      ToVector(last.model)[index],
                      kPlusMinus,
                      last.std[index],
                      UnitOfParameter(index, dof))};
}

std::string SentenceOn(const FollowedEstimate& last) {
  if (last.usable) {
    return "The last estimate is usable. Behind ± stands its scatter over the last third of the "
           "samples, which is no standard error.";
  }
  if (std::isnan(last.std[kInertia])) {
    return "The last estimate is not usable: there are fewer than ten samples.";
  }
  return "The last estimate is not usable: " + WhyUnusable(last.model, last.std[kInertia]);
}

}  // namespace

Page FollowPage(const EstimateHistory& history, Dof dof, const AdaptiveOptions& options) {
  const std::vector<FollowedEstimate> estimates = history.Thinned();
  const std::vector<FollowedEstimate> shown = BehindTheStart(estimates);
  const FollowedEstimate& last = estimates.back();
  Page page;
  page.title = fmt::format("{}, followed by the adaptive law", Name(dof));
  page.subtitle = fmt::format("{}, t = {:.6g} s to {:.6g} s",
                              Plural(history.num_estimates(), "sample"),
                              estimates.front().t,
                              last.t);
  page.lead = {SentenceOn(last)};
  if (!std::isnan(last.std[kInertia])) {
    for (int k = 0; k < kNumParameters; ++k) page.facts.push_back(LastOf(last, k, dof));
  }
  if (options.gains) page.facts.push_back({"gains", FormatGains(*options.gains)});
  if (history.stride() > 1) {
    page.facts.push_back({"shown", fmt::format("one estimate of {}", history.stride())});
  }
  PageSection section;
  section.heading = "Estimates over time";
  if (std::ranges::any_of(shown, &FollowedEstimate::usable)) {
    for (int k = 0; k < kNumParameters; ++k) {
      section.time_panels.push_back(PanelOf(shown, k, dof));
    }
  } else {
    section.text = {"None was usable so far."};
  }
  page.sections.push_back(std::move(section));
  page.footer =
      "The first tenth of the estimates is not shown. The scatter is that of the estimate over the "
      "last third of the samples so far. It is no "
      "standard error, and does not cover parameters that have not settled or effects that the "
      "model lacks.";
  return page;
}

}  // namespace fathom
