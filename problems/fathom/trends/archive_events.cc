// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/archive_events.h"

#include "fathom/solve/decompositions.h"
#include "fathom/trends/scan.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <utility>

namespace fathom {
namespace {

constexpr int kLeastDivesOfSeries = 5;
constexpr int kMostRenamings = 4;
constexpr double kLeastGain = 14.0;        // of chi-square, of an event's first parameter
constexpr double kLeastFurtherGain = 3.0;  // and of each other one
constexpr double kShownDeviations = 3.0;
constexpr int kFarthestMove = 5;           // of a step, in dives
constexpr double kShareOfNeighbour = 0.8;  // of its likelihood: one dive off is nearly as good

std::vector<DiveSeries> SeriesWithout(std::span<const ParameterOutlier> outliers,
                                      std::span<const DiveEstimate> estimates,
                                      int num_dives) {
  std::vector<DiveSeries> series = SeriesOf(estimates, num_dives, kLeastDivesOfSeries);
  for (DiveSeries& one : series) {
    for (const ParameterOutlier& outlier : outliers) {
      if (!AreOfOneSeries(outlier, one)) continue;
      const auto place = std::find(one.dive.begin(), one.dive.end(), outlier.dive);
      if (place == one.dive.end()) continue;
      one = WithoutElement(one, static_cast<int>(place - one.dive.begin()));
    }
  }
  return series;
}

bool AreOne(const Column& a, const Column& b) {
  if (a.kind != b.kind) return false;
  return a.kind == ChangeKind::kTrend || std::abs(a.at - b.at) <= 1;
}

std::vector<EventColumn> ColumnsOf(const ArchiveEvents& archive) {
  std::vector<EventColumn> columns;
  for (const ArchiveEvent& event : archive.events) columns.push_back(event.column);
  return columns;
}

void EstimateScatter(ArchiveEvents* archive) {
  archive->tau_squared.clear();
  for (std::size_t s = 0; s < archive->series.size(); ++s) {
    std::vector<Column> columns;
    for (const ArchiveEvent& event : archive->events) {
      if (event.column.moves[s]) columns.push_back(event.column.column);
    }
    const DiveSeries& one = archive->series[s];
    const ScanDesign design = MakeScanDesign(one, columns, archive->num_dives);
    archive->tau_squared.push_back(Scan(design, one.value).tau_squared);
  }
}

// Chi-square of the differences of the series in `members`, and how many those are.
std::pair<double, int> GainOf(const EventFit& fit, std::span<const char> members) {
  const Eigen::Index m = fit.before.size();
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < m; ++i) {
    if (members[fit.series[i]]) rows.push_back(i);
  }
  if (rows.empty()) return {0.0, 0};
  const Eigen::MatrixXd covariance = fit.covariance.bottomRightCorner(m, m)(rows, rows);
  const Eigen::VectorXd difference = fit.difference(rows);
  return {difference.dot(SolveSymmetric(covariance, difference)), static_cast<int>(rows.size())};
}

// Events that the others explain go, the least telling first.
void DropTheExplained(ArchiveEvents* archive) {
  while (archive->events.size() > 1) {
    std::size_t weakest = 0;
    double least = 0.0;
    for (std::size_t e = 0; e < archive->events.size(); ++e) {
      const auto [gain, size] = GainOf(FitOf(*archive, e), archive->events[e].found);
      const double spare = gain - kLeastGain - kLeastFurtherGain * (size - 1);
      if (spare >= least) continue;
      least = spare;
      weakest = e;
    }
    if (least >= 0.0) return;
    archive->events.erase(archive->events.begin() + weakest);
    EstimateScatter(archive);
  }
}

std::vector<char> MovedBy(const ArchiveEvent& event, const EventFit& fit) {
  std::vector<char> moves(event.found.size(), 0);
  for (const NamedCause& named : event.judged.causes) {
    if (named.cause == "unnamed") {
      moves = event.found;
      const Eigen::Index m = fit.before.size();
      for (Eigen::Index i = 0; i < m; ++i) {
        const double std = std::sqrt(fit.covariance(m + i, m + i));
        if (std::abs(fit.difference(i)) > kShownDeviations * std) moves[fit.series[i]] = 1;
      }
      continue;
    }
    for (std::size_t s = 0; s < moves.size(); ++s) moves[s] |= named.pattern.Moves(s) ? 1 : 0;
  }
  return moves;
}

// Moves a step to the dive nearby that, with the dives next to it, is the likeliest by the series
// that it moves. The single likeliest one is further off more often.
void Place(std::size_t e, ArchiveEvents* archive) {
  Column& column = archive->events[e].column.column;
  if (column.kind == ChangeKind::kTrend) return;
  const std::vector<char> moves = archive->events[e].column.moves;
  const int first = std::max(column.at - kFarthestMove, 2);
  const int last = std::min(column.at + kFarthestMove, archive->num_dives - 2);
  if (first > last) return;
  Eigen::ArrayXd gain(last - first + 1);
  for (int i = 0; i < gain.size(); ++i) {
    column.at = first + i;
    gain(i) = GainOf(FitOf(*archive, e), moves).first;
  }
  const Eigen::ArrayXd likelihood = (0.5 * (gain - gain.maxCoeff())).exp();
  double most = -1.0;
  for (int i = 0; i < gain.size(); ++i) {
    double nearby = likelihood(i);
    if (i > 0) nearby += kShareOfNeighbour * likelihood(i - 1);
    if (i + 1 < gain.size()) nearby += kShareOfNeighbour * likelihood(i + 1);
    if (nearby <= most) continue;
    most = nearby;
    column.at = first + i;
  }
}

void Name(ArchiveEvents* archive) {
  for (int round = 0; round < kMostRenamings; ++round) {
    bool has_changed = false;
    for (std::size_t e = 0; e < archive->events.size(); ++e) {
      ArchiveEvent& event = archive->events[e];
      const EventFit fit = FitOf(*archive, e);
      event.judged =
          Judge(fit, PatternsAt(archive->patterns, event.column.column), archive->num_dives);
      const std::vector<char> moves = MovedBy(event, fit);
      const Column before = event.column.column;
      has_changed = has_changed || moves != event.column.moves;
      event.column.moves = moves;
      Place(e, archive);
      has_changed = has_changed || !(before == event.column.column);
      EstimateScatter(archive);
    }
    if (!has_changed) return;
  }
}

// What it takes to explain an archive.
struct Effort {
  int num_causes = 0;  // one without a name counts three
  int num_free = 0;    // numbers of those with a name

  auto operator<=>(const Effort&) const = default;
};

Effort EffortOf(const ArchiveEvents& archive) {
  Effort effort;
  for (const ArchiveEvent& event : archive.events) {
    for (const NamedCause& named : event.judged.causes) {
      effort.num_causes += named.cause == "unnamed" ? 3 : 1;
      effort.num_free += named.pattern.NumFree();
    }
  }
  return effort;
}

bool HasTrend(const ArchiveEvents& archive) {
  return std::any_of(archive.events.begin(), archive.events.end(), [](const ArchiveEvent& event) {
    return event.column.column.kind == ChangeKind::kTrend;
  });
}

// A slope is not a stack of steps: damping that grows from dive to dive, beside steps of other
// parameters, can look like a step of the damping with each of them. Takes a trend of all damping
// in place of such steps where that explains the archive by fewer causes, or by as many of fewer
// numbers.
void TakeTrendForSteps(ArchiveEvents* archive) {
  if (HasTrend(*archive)) return;
  ArchiveEvents other = *archive;
  std::vector<char> damping(other.series.size(), 0);
  for (std::size_t s = 0; s < damping.size(); ++s) {
    const int parameter = other.series[s].parameter;
    damping[s] = parameter == kQuadraticDamping || parameter == kLinearDamping ? 1 : 0;
  }
  other.events.push_back({{{ChangeKind::kTrend, 0}, damping}, damping, {}});
  EstimateScatter(&other);
  DropTheExplained(&other);
  if (!HasTrend(other)) return;
  Name(&other);
  if (EffortOf(other) < EffortOf(*archive)) *archive = std::move(other);
}

}  // namespace

ArchiveEvents MakeArchiveEvents(std::span<const ParameterOutlier> outliers,
                                std::span<const DiveEstimate> estimates,
                                int num_dives,
                                const std::optional<Vehicle>& vehicle) {
  ArchiveEvents archive;
  archive.num_dives = num_dives;
  archive.series = SeriesWithout(outliers, estimates, num_dives);
  archive.blocks = BlocksOf(estimates, archive.series);
  archive.patterns = PatternsOf(archive.series,
                                estimates,
                                num_dives,
                                MeanCorrelation(archive.blocks, archive.series.size()),
                                vehicle);
  return archive;
}

bool AddEvents(std::span<const Change> changes, ArchiveEvents* archive) {
  const std::size_t known = archive->events.size();
  for (const Change& change : changes) {
    const Column column{change.kind, change.kind == ChangeKind::kTrend ? 0 : change.at};
    auto event =
        std::find_if(archive->events.begin(), archive->events.end(), [&](const ArchiveEvent& e) {
          return AreOne(e.column.column, column);
        });
    if (event == archive->events.end()) {
      const std::vector<char> all(archive->series.size(), 1);
      const std::vector<char> none(archive->series.size(), 0);
      archive->events.push_back({{column, all}, none, {}});
      event = archive->events.end() - 1;
    }
    for (std::size_t s = 0; s < archive->series.size(); ++s) {
      const DiveSeries& one = archive->series[s];
      if (AreOfOneSeries(one, change)) event->found[s] = 1;
    }
  }
  return archive->events.size() > known;
}

void Settle(ArchiveEvents* archive) {
  EstimateScatter(archive);
  DropTheExplained(archive);
  Name(archive);
  TakeTrendForSteps(archive);
}

EventFit FitOf(const ArchiveEvents& archive, std::size_t index) {
  return FitEvent(archive.series,
                  archive.blocks,
                  archive.tau_squared,
                  ColumnsOf(archive),
                  index,
                  archive.num_dives);
}

std::vector<KnownChange> KnownOf(const ArchiveEvents& archive) {
  std::vector<KnownChange> known;
  for (const ArchiveEvent& event : archive.events) {
    for (std::size_t s = 0; s < archive.series.size(); ++s) {
      if (!event.column.moves[s]) continue;
      const DiveSeries& one = archive.series[s];
      known.push_back({one.dof, one.parameter, event.column.column, one.entry});
    }
  }
  return known;
}

}  // namespace fathom
