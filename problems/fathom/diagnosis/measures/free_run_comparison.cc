// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/free_run_comparison.h"

#include <utility>
#include <vector>

namespace fathom {
namespace {

// Of free runs over the training data.
FitFigures TrainFigures(const TrainingData& data,
                        const ExtendedModel& model,
                        const std::vector<InitialState>& initial) {
  std::vector<FreeRun> runs;
  for (std::size_t r = 0; r < data.segments().size(); ++r) {
    if (auto run = RunFrom(initial[r], data.segments()[r], model)) runs.push_back(std::move(*run));
  }
  return FiguresOfRuns(runs);
}

}  // namespace

Scored UnseenRuns(const Prepared& prepared,
                  const LeftOutParts& parts,
                  const StructureFit& fit,
                  Criterion criterion) {
  return prepared.held_out.empty() ? Score(parts, fit, criterion)
                                   : Score(prepared.held_out, prepared.users.model, fit.model);
}

FreeRunComparison CompareWithUsers(const Prepared& prepared,
                                   std::shared_ptr<const LeftOutParts> parts,
                                   const StructureFit& fit,
                                   Criterion criterion,
                                   bool acts_on_poses_alone) {
  const StartedModel& users = prepared.users;
  FreeRunComparison runs;
  runs.unseen = UnseenRuns(prepared, *parts, fit, criterion);
  runs.train_before = TrainFigures(prepared.data, users.model, users.initial);
  runs.train_after = TrainFigures(prepared.data, fit.model, fit.initial);
  runs.gain = GainOf(runs.unseen, acts_on_poses_alone);
  if (prepared.held_out.empty()) runs.parts = std::move(parts);
  return runs;
}

FreeRunComparison OfUsersAlone(FreeRunComparison runs) {
  runs.train_after = runs.train_before;
  runs.unseen.after = runs.unseen.before;
  runs.unseen.poses_after = runs.unseen.poses_before;
  runs.gain = GainOf(runs.unseen, false);
  return runs;
}

}  // namespace fathom
