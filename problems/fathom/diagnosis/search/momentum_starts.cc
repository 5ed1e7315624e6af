// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/momentum_starts.h"

#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/data/part_of_segment.h"
#include "fathom/diagnosis/fit/momentum_balance.h"
#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/diagnosis/search/refinement.h"
#include "fathom/diagnosis/search/screen/trial_values.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr double kShortestPiece = 2.0;  // [s]
constexpr double kMostPieces = 40.0;
constexpr std::size_t kLeastPieceSamples = 6;  // of a piece

struct MomentumStart {
  int suspect = 0;
  MomentumFit fit;
};

// The best value of each suspect that the measured motion tells of, the best suspect first.
std::vector<MomentumStart> StartsByMomentum(const SearchTask& task) {
  const MomentumBalance balance(task.data.segments());
  const RunScale scale = MeasuredScale(task.data);
  std::vector<MomentumStart> starts;
  for (int k = 0; k < task.num_suspects(); ++k) {
    const Suspect& suspect = task.suspects[k];
    const EffectInfo& info = suspect.effect->info();
    if (info.scope == Scope::kRun || !MomentumBalance::HasForce(*suspect.effect)) continue;
    std::optional<MomentumFit> best;
    for (auto& values : CombinationsOf(info, task.data, scale)) {
      auto fit = balance.FitWith({suspect.effect, suspect.setting, std::move(values)});
      if (fit && (!best || fit->squared_error < best->squared_error)) best = std::move(fit);
    }
    if (best) starts.push_back({k, *std::move(best)});
  }
  std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) {
    return a.fit.squared_error < b.fit.squared_error;
  });
  return starts;
}

StructureFit RoughFit(const TrainingData& data,
                      const ExtendedModel& start,
                      const FitPrecision& precision) {
  std::vector<InitialState> initial;
  for (const MeasuredSegment& segment : data.segments()) initial.push_back(segment.initial);
  const auto simulated = data.Simulate(start, initial);
  if (!simulated) return {};
  const NoiseModel noise = WhiteNoise(data, data.measured() - *simulated);
  return FitStructure(data, start, initial, Whitener(noise, data.samples()), precision);
}

// The same data in pieces that each start anew: a short run goes astray less, and friction that
// holds the vehicle, or a spring, has no minimum there for every stop or swing.
TrainingData InPieces(const TrainingData& data) {
  double total = 0.0;
  for (const MeasuredSegment& segment : data.segments()) total += segment.duration();
  const double length = std::max(kShortestPiece, total / kMostPieces);
  std::vector<MeasuredSegment> pieces;
  for (const MeasuredSegment& segment : data.segments()) {
    const double start = segment.stamps.start;
    const int count = std::max(1, static_cast<int>(segment.duration() / length));
    for (int k = 0; k < count; ++k) {
      const double from = start + segment.duration() * k / count;
      const double to = start + segment.duration() * (k + 1) / count;
      if (auto piece = PartOf(segment, from, to, kLeastPieceSamples))
        pieces.push_back(*std::move(piece));
    }
  }
  return TrainingData(std::move(pieces), {}, data.least_inertia());
}

}  // namespace

HypothesisBook WithSinglesByMomentum(const SearchTask& task, HypothesisBook book) {
  const TrainingData pieces = InPieces(task.data);
  if (pieces.segments().empty()) return book;
  std::vector<MomentumStart> starts = StartsByMomentum(task);
  if (std::ssize(starts) > task.options.most_from_momentum) {
    starts.resize(task.options.most_from_momentum);
  }
  const double most_gain = book.MostGain();
  std::vector<Hypothesis> found(starts.size());
  ParallelFor(static_cast<int>(starts.size()), [&](int i) {
    const StructureFit in_pieces = RoughFit(pieces, starts[i].fit.model, task.options.rough);
    if (!in_pieces.IsSimulated()) return;
    const StructureFit rough = RoughFit(task.data, in_pieces.model, task.options.rough);
    if (!rough.IsSimulated()) return;
    found[i] =
        BegunFrom(task, book.baseline(), book.baseline(), {starts[i].suspect}, rough, most_gain);
  });
  for (const MomentumStart& start : starts) book.AddAttempt({start.suspect});
  return WithSettled(task, std::move(found), most_gain, std::move(book));
}

}  // namespace fathom
