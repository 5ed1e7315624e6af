// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/change_search.h"

#include "fathom/trends/found_change.h"
#include "fathom/trends/partner_noise.h"
#include "fathom/trends/quiet_archive.h"
#include "fathom/trends/series_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kLeastDives = 5;
constexpr int kDivesOfLongSeries = 25;
constexpr int kManyDives = 300;  // have fewer draws
constexpr int kFewDraws = 199;
constexpr int kMostRounds = 20;  // each adds a change to every series that has one left

std::vector<SeriesModel> StartModels(std::span<const DiveEstimate> estimates,
                                     int num_dives,
                                     std::span<const KnownChange> known) {
  std::vector<SeriesModel> models;
  for (DiveSeries& series : SeriesOf(estimates, num_dives, kLeastDives)) {
    SeriesModel model{std::move(series), {}, {}};
    for (const KnownChange& change : known) {
      if (AreOfOneSeries(change, model.series)) model.known.push_back(change.column);
    }
    models.push_back(std::move(model));
  }
  return models;
}

// Each series beside what its partners say of its noise.
struct Round {
  std::vector<DiveSeries> series;  // cleared of it
  std::vector<DiveBlock> blocks;
  PartnerNoise partner_noise;
  std::vector<ScanDesign> designs;
  std::vector<ScanResult> scans;
  std::vector<double> tau_squared;
};

// A change that is not in the model yet must not count as scatter. In short series the best of many
// candidates would take the scatter with it.
double TauSquaredBesideTheBest(const ScanResult& scan) {
  const int best = BestChange(scan).index;
  const int num_dives = static_cast<int>(scan.statistic.size() / 2);
  if (best < 0 || num_dives < kDivesOfLongSeries) return scan.tau_squared;
  return scan.candidate_tau_squared(best);
}

Round ScanAll(std::span<const DiveEstimate> estimates,
              std::span<const SeriesModel> models,
              int num_dives) {
  Round round;
  std::vector<std::vector<Column>> columns;
  std::vector<Eigen::VectorXd> values;
  for (const SeriesModel& model : models) {
    round.series.push_back(model.series);
    columns.push_back(AllColumns(model));
    values.push_back(model.series.value);
    const ScanDesign alone = MakeScanDesign(model.series, columns.back(), num_dives);
    round.tau_squared.push_back(TauSquaredBesideTheBest(Scan(alone, model.series.value)));
  }
  round.blocks = BlocksOf(estimates, round.series);
  round.partner_noise =
      PartnerNoiseOf(round.series, round.blocks, round.tau_squared, columns, num_dives);
  values = WithoutPartners(values, round.partner_noise);
  for (std::size_t s = 0; s < models.size(); ++s) {
    round.series[s].value = values[s];
    round.series[s].variance = round.partner_noise.variance[s];
    round.designs.push_back(MakeScanDesign(round.series[s], columns[s], num_dives));
    round.scans.push_back(Scan(round.designs.back(), values[s]));
  }
  return round;
}

ParameterOutlier RemoveOutlier(int element, SeriesModel* model) {
  const DiveSeries& series = model->series;
  const ParameterOutlier outlier{series.dive[element], series.dof, series.parameter, series.entry};
  model->series = WithoutElement(series, element);
  return outlier;
}

// The most telling step, trend or outlier of one series.
struct Finding {
  std::size_t series = 0;
  ScanCandidate candidate;
  bool is_outlier = false;
  double p_value = 1.0;
};

void Consider(const Finding& finding, double rate, std::optional<Finding>* best) {
  if (finding.candidate.index < 0 || finding.p_value > rate) return;
  if (!best->has_value() || finding.candidate.statistic > (*best)->candidate.statistic)
    *best = finding;
}

// Parameters whose noise goes together: those of one DOF, and all of a coupled model.
constexpr std::size_t kNumGroups = 7;

std::size_t GroupOf(const DiveSeries& series) {
  return series.entry ? kNumGroups - 1 : static_cast<std::size_t>(Index(series.dof));
}

// By group: the most telling parameter of it comes first, and the others are judged beside it.
std::array<std::optional<Finding>, kNumGroups> TellingFindings(const Round& round,
                                                               const CommonScale& changes,
                                                               const CommonScale& dives,
                                                               const ChangeOptions& options) {
  std::array<std::optional<Finding>, kNumGroups> findings;
  for (std::size_t s = 0; s < round.scans.size(); ++s) {
    std::optional<Finding>& best = findings[GroupOf(round.series[s])];
    const ScanCandidate change = BestChange(round.scans[s]);
    const ScanCandidate dive = BestDive(round.scans[s]);
    const double change_p = PValue(changes.largest, changes.OnScale(s, change.statistic));
    const double dive_p = PValue(dives.largest, dives.OnScale(s, dive.statistic));
    std::optional<Finding> own;
    Consider({s, change, false, change_p}, options.false_alarm_rate, &own);
    Consider({s, dive, true, dive_p}, options.outlier_rate, &own);
    if (own) Consider(*own, 1.0, &best);
  }
  return findings;
}

int NumDraws(int num_dives, const ChangeOptions& options) {
  return num_dives > kManyDives ? std::min(options.num_draws, kFewDraws) : options.num_draws;
}

// Adds one more change or outlier to every group that has one which quiet archives do not. False if
// there is none.
bool AddTheTelling(std::span<const DiveEstimate> estimates,
                   int num_dives,
                   const ChangeOptions& options,
                   std::vector<SeriesModel>* models,
                   std::vector<ParameterOutlier>* outliers) {
  const Round round = ScanAll(estimates, *models, num_dives);
  const QuietArchives quiet = DrawQuietArchives(round.blocks,
                                                round.series,
                                                round.designs,
                                                round.tau_squared,
                                                round.partner_noise,
                                                NumDraws(num_dives, options),
                                                options.seed);
  const CommonScale changes = CommonScaleOf(quiet.change);
  const double threshold = ThresholdAt(changes.largest, options.false_alarm_rate);
  bool has_added = false;
  for (const std::optional<Finding>& finding :
       TellingFindings(round, changes, CommonScaleOf(quiet.dive), options)) {
    if (!finding) continue;
    has_added = true;
    const std::size_t s = finding->series;
    SeriesModel& model = (*models)[s];
    const int index = finding->candidate.index;
    if (finding->is_outlier) {
      outliers->push_back(RemoveOutlier(index - round.designs[s].num_dives, &model));
      continue;
    }
    model.found.push_back({ColumnOf(model.series, index), finding->p_value});
    SeriesModel cleared = model;
    cleared.series = round.series[s];
    model.found =
        Reconsidered(std::move(cleared), changes.FromScale(s, threshold), num_dives).found;
  }
  return has_added;
}

}  // namespace

ChangeSearch FindChanges(std::span<const DiveEstimate> estimates,
                         int num_dives,
                         const ChangeOptions& options,
                         std::span<const KnownChange> known) {
  CHECK(options.Problems().empty()) << options.Problems().front();
  std::vector<SeriesModel> models = StartModels(estimates, num_dives, known);
  ChangeSearch search;
  for (int round = 0; round < kMostRounds; ++round) {
    if (!AddTheTelling(estimates, num_dives, options, &models, &search.outliers)) break;
  }
  const Round last = ScanAll(estimates, models, num_dives);
  for (std::size_t s = 0; s < models.size(); ++s) {
    const SeriesModel& model = models[s];
    search.scatter.push_back({model.series.dof,
                              model.series.parameter,
                              model.series.scale * std::sqrt(last.tau_squared[s]),
                              static_cast<int>(model.series.dive.size()),
                              model.series.entry});
    for (std::size_t i = 0; i < model.found.size(); ++i) {
      search.changes.push_back(ChangeOf(model, i, last.tau_squared[s], num_dives));
    }
  }
  std::stable_sort(search.changes.begin(),
                   search.changes.end(),
                   [](const Change& a, const Change& b) { return a.p_value < b.p_value; });
  return search;
}

}  // namespace fathom
