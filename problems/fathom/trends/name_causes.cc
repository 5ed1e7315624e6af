// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/name_causes.h"

#include "fathom/trends/archive_events.h"
#include "fathom/trends/event_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kMostSearches = 4;

std::vector<Change> ChangesOf(const ArchiveEvents& archive,
                              const ArchiveEvent& event,
                              const NamedCause& named,
                              const EventFit& fit,
                              std::span<const Change> found) {
  std::vector<Change> changes;
  const Eigen::Index m = fit.before.size();
  for (Eigen::Index i = 0; i < m; ++i) {
    const int s = fit.series[i];
    const bool is_told =
        named.cause == "unnamed" ? event.column.moves[s] != 0 : named.pattern.Moves(s);
    if (!is_told) continue;
    const DiveSeries& one = archive.series[s];
    Change change;
    change.dof = one.dof;
    change.parameter = one.parameter;
    change.entry = one.entry;
    change.kind = event.column.column.kind;
    change.at = event.column.column.at;
    const double scale = one.scale;
    change.before = scale * fit.before(i);
    change.after = scale * (fit.before(i) + fit.difference(i));
    change.before_std = scale * std::sqrt(fit.covariance(i, i));
    change.after_std = scale * std::sqrt(fit.covariance(i, i) + fit.covariance(m + i, m + i) +
                                         2.0 * fit.covariance(i, m + i));
    for (const Change& other : found) {
      const bool is_it = AreOfOneSeries(other, change) && other.kind == change.kind;
      const bool is_there =
          change.kind == ChangeKind::kTrend || std::abs(other.at - change.at) <= 1;
      if (is_it && is_there) change.p_value = other.p_value;
    }
    changes.push_back(change);
  }
  return changes;
}

std::vector<ChangeEvent> Told(const ArchiveEvents& archive,
                              std::span<const Change> found,
                              std::span<const std::string> dive_names) {
  std::vector<ChangeEvent> told;
  for (std::size_t e = 0; e < archive.events.size(); ++e) {
    const ArchiveEvent& event = archive.events[e];
    const EventFit fit = FitOf(archive, e);
    for (const NamedCause& named : event.judged.causes) {
      ChangeEvent one;
      one.cause = named.cause;
      one.alternatives = event.judged.alternatives;
      one.changes = ChangesOf(archive, event, named, fit, found);
      one.text = EventText(named,
                           one.alternatives,
                           fit,
                           event.column.column,
                           archive.series,
                           event.column.moves,
                           dive_names);
      if (!one.changes.empty()) told.push_back(one);
    }
  }
  std::stable_sort(told.begin(), told.end(), [](const ChangeEvent& a, const ChangeEvent& b) {
    return a.changes[0].at < b.changes[0].at;
  });
  return told;
}

}  // namespace

std::vector<ChangeEvent> NameCauses(const ChangeSearch& search,
                                    std::span<const DiveEstimate> estimates,
                                    std::span<const std::string> dive_names,
                                    const std::optional<Vehicle>& vehicle,
                                    const ChangeOptions& options) {
  for (const DiveEstimate& estimate : estimates) {
    CHECK_LT(static_cast<std::size_t>(estimate.dive), dive_names.size());
  }
  if (search.changes.empty()) return {};
  ArchiveEvents archive =
      MakeArchiveEvents(search.outliers, estimates, static_cast<int>(dive_names.size()), vehicle);
  std::vector<Change> found = search.changes;
  AddEvents(found, &archive);
  for (int i = 0; i < kMostSearches; ++i) {
    Settle(&archive);
    const ChangeSearch further =
        FindChanges(estimates, archive.num_dives, options, KnownOf(archive));
    found.insert(found.end(), further.changes.begin(), further.changes.end());
    if (!AddEvents(further.changes, &archive)) break;
  }
  return Told(archive, found, dive_names);
}

}  // namespace fathom
