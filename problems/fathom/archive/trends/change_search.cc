// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/trends/change_search.h"

#include "fathom/archive/trends/found_change.h"
#include "fathom/archive/trends/quiet_archive.h"
#include "fathom/archive/trends/series_model.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kLeastDives = 5;
constexpr int kMostRounds = 20;  // each adds a change to every series that has one left

std::vector<SeriesModel> StartModels(std::span<const DiveEstimate> estimates,
                                     int num_dives,
                                     std::span<const KnownChange> known) {
  std::vector<SeriesModel> models;
  for (Series& series : SeriesOf(estimates, num_dives, kLeastDives)) {
    SeriesModel model{std::move(series), {}, {}};
    for (const KnownChange& change : known) {
      const bool is_of_it =
          change.dof == model.series.dof && change.parameter == model.series.parameter;
      if (is_of_it) model.known.push_back(change.column);
    }
    models.push_back(std::move(model));
  }
  return models;
}

struct Round {
  std::vector<Series> series;
  std::vector<ScanDesign> designs;
  std::vector<ScanResult> scans;
  std::vector<double> tau_squared;
};

// A change that is not in the model yet must not count as scatter.
double TauSquaredBesideTheBest(const ScanResult& scan) {
  const int best = BestChange(scan).index;
  return best < 0 ? scan.tau_squared : scan.candidate_tau_squared(best);
}

Round ScanAll(std::span<const SeriesModel> models, int num_dives) {
  Round round;
  for (const SeriesModel& model : models) {
    round.series.push_back(model.series);
    round.designs.push_back(MakeScanDesign(model.series, AllColumns(model), num_dives));
    round.scans.push_back(Scan(round.designs.back(), model.series.value));
    round.tau_squared.push_back(TauSquaredBesideTheBest(round.scans.back()));
  }
  return round;
}

OutlyingDive RemoveOutlier(int element, SeriesModel* model) {
  const Series& series = model->series;
  const OutlyingDive outlier{series.dive[element], series.dof, series.parameter};
  model->series = WithoutElement(series, element);
  return outlier;
}

// One more change or outlier in every series that has one which quiet archives do not. False if
// there is none.
bool AddTheTelling(std::span<const DiveEstimate> estimates,
                   int num_dives,
                   const ChangeOptions& options,
                   std::vector<SeriesModel>* models,
                   std::vector<OutlyingDive>* outliers) {
  const Round round = ScanAll(*models, num_dives);
  const QuietArchives quiet = DrawQuietArchives(BlocksOf(estimates, round.series),
                                                round.series,
                                                round.designs,
                                                round.tau_squared,
                                                options.num_draws,
                                                options.seed);
  const CommonScale changes = CommonScaleOf(quiet.change);
  const CommonScale dives = CommonScaleOf(quiet.dive);
  bool has_added = false;
  for (std::size_t s = 0; s < models->size(); ++s) {
    SeriesModel& model = (*models)[s];
    const Candidate change = BestChange(round.scans[s]);
    const Candidate dive = BestDive(round.scans[s]);
    const double p_value = PValue(changes.largest, changes.OnScale(s, change.statistic));
    const bool has_change = change.index >= 0 && p_value <= options.false_alarm_rate;
    const bool has_outlier =
        dive.index >= 0 &&
        PValue(dives.largest, dives.OnScale(s, dive.statistic)) <= options.outlier_rate;
    if (!has_change && !has_outlier) continue;
    has_added = true;
    if (has_outlier && (!has_change || dive.statistic > change.statistic)) {
      outliers->push_back(RemoveOutlier(dive.index - round.designs[s].num_dives, &model));
      continue;
    }
    model.found.push_back({ColumnOf(model.series, change.index), p_value});
    const double threshold =
        changes.FromScale(s, ThresholdAt(changes.largest, options.false_alarm_rate));
    model = Reconsidered(std::move(model), threshold, num_dives);
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
  const Round last = ScanAll(models, num_dives);
  for (std::size_t s = 0; s < models.size(); ++s) {
    const SeriesModel& model = models[s];
    search.scatter.push_back({model.series.dof,
                              model.series.parameter,
                              model.series.scale * std::sqrt(last.scans[s].tau_squared),
                              static_cast<int>(model.series.dive.size())});
    for (std::size_t i = 0; i < model.found.size(); ++i) {
      search.changes.push_back(ChangeOf(model, i, last.scans[s].tau_squared, num_dives));
    }
  }
  std::stable_sort(search.changes.begin(),
                   search.changes.end(),
                   [](const Change& a, const Change& b) { return a.p_value < b.p_value; });
  return search;
}

}  // namespace fathom
