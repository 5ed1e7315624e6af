// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/search_data.h"

#include "fathom/diagnosis/data/thinned.h"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace fathom {
namespace {

constexpr double kOfBin = 0.5;  // width of what is averaged, of a bin's

// Chi squared, of which a cause has to gain ten times as much.
constexpr double kUnseen = 1.0;

// The segments with a run of the model in the place of what was measured.
std::optional<std::vector<MeasuredSegment>> RunsOver(std::vector<MeasuredSegment> segments,
                                                     const StructureFit& fit) {
  EffectOutputs outputs;
  for (std::size_t r = 0; r < segments.size(); ++r) {
    MeasuredSegment& segment = segments[r];
    const EffectSimulation simulation(segment.inputs.get(), segment.stamps);
    if (!simulation.Run(fit.model, fit.initial[r], &outputs)) return std::nullopt;
    segment.velocity = outputs.velocity;
    segment.displacement = outputs.displacement;
  }
  return segments;
}

// Whether a run over thinned data is, but for less than noise, a thinned run.
bool IsUnseen(const TrainingData& data, const StructureFit& fit, double width) {
  const auto runs = RunsOver(data.segments(), fit);
  if (!runs) return false;
  const TrainingData thinned(Thinned(*runs, width), fit.model.baseline);
  const auto simulated = thinned.Simulate(fit.model, fit.initial);
  if (!simulated) return false;
  Eigen::VectorXd difference = thinned.measured() - *simulated;
  const std::span<double> values(difference.data(), difference.size());
  Whitener(fit.noise, thinned.samples()).Apply(values, values);
  return difference.squaredNorm() < kUnseen;
}

}  // namespace

std::vector<MeasuredSegment> SearchDataOf(const TrainingData& data, const StructureFit& fit) {
  const double coarse = kOfBin * BinWidthFor(data.segments());
  return Thinned(data.segments(), IsUnseen(data, fit, coarse) ? coarse : kFineWidth);
}

}  // namespace fathom
