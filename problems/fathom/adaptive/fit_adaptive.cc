// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/fit_adaptive.h"

#include "fathom/adaptive/choose_gains.h"
#include "fathom/adaptive/inertia_step.h"
#include "fathom/adaptive/pass.h"
#include "fathom/adaptive/usable_estimate.h"
#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kSettledChange = 0.1;  // of the inertia over the last part
constexpr double kSettledStep = 0.04;   // of the inertia, by output error from the end

using Models = std::vector<ParameterVector>;

// Mean square about the final estimate, so that a drift counts as scatter.
ParameterCovariance ScatterAbout(const ParameterVector& final, const Models& models) {
  ParameterCovariance scatter = ParameterCovariance::Zero();
  for (const ParameterVector& model : models) {
    scatter += (model - final) * (model - final).transpose();
  }
  return scatter / static_cast<double>(models.size());
}

// Whether the law has come to where the velocities ask it to be; empty if it has.
std::string CaveatOnInertia(double inertia, double change, double step) {
  if (std::isfinite(step) && std::abs(step) > kSettledStep) {
    return fmt::format(
        "The inertia has not settled: a step of output error from here would change it by "
        "{:+.0f} %. Take the family output_error, or excite the vehicle faster.",
        100.0 * step);
  }
  if (std::isfinite(step) && std::abs(change) <= kSettledChange * inertia) return "";
  return fmt::format(
      "The inertia has not settled: it changed by {:.3g} over the last third of the pass.", change);
}

void AddCaveats(const Models& last_part, double step, AdaptiveSummary* summary) {
  const double inertia = summary->model.inertia;
  const double change = inertia - last_part.front()[kInertia];
  if (std::string caveat = CaveatOnInertia(inertia, change, step); !caveat.empty()) {
    summary->caveats.push_back(std::move(caveat));
  }
  for (const int index : {kQuadraticDamping, kLinearDamping}) {
    const double value = ToVector(summary->model)[index];
    if (value >= 0.0) continue;
    summary->caveats.push_back(
        fmt::format("{} is negative ({:.4g}), which is unphysical. The fit takes another term or "
                    "an unmodelled effect for damping.",
                    kParameterInfo[index].name,
                    value));
  }
  summary->caveats.emplace_back(
      "The intervals are the scatter of the estimate over the last third of the pass and not "
      "standard errors. They do not cover parameters that have not converged, combinations that "
      "the motion does not excite, or effects that the model lacks.");
}

}  // namespace

AdaptiveSummary FitAdaptive(std::span<const Segment> segments, const AdaptiveOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("The options of the adaptive identifier cannot be used: {}",
                                 fmt::join(problems, "; ")));
  }
  AdaptiveSummary summary;
  const std::vector<PassSegment> pass = PassOver(segments);
  size_t n = 0;
  for (const PassSegment& segment : pass) n += segment.time.size();
  summary.num_samples = static_cast<int>(n);
  summary.gains = options.gains ? *options.gains : ChooseGains(segments);
  if (!summary.gains.Problems().empty()) {
    summary.message =
        n < 3 ? fmt::format("Only {} samples.", n)
              : "No gains were found: the force or the motion is zero, or every pass diverges.";
    return summary;
  }

  AdaptiveIdentifier identifier({.gains = summary.gains, .integrator = options.integrator});
  const size_t last_part_begin = BeginOfLastPart(n);
  Models last_part;
  Feed(pass, &identifier, [&] {
    const auto k = static_cast<size_t>(identifier.num_samples() - 1);
    if (k >= last_part_begin) last_part.push_back(ToVector(identifier.Estimate()));
  });
  if (!identifier.IsFinite()) {
    summary.message = "The adaptive law diverged: the step is too long for these gains.";
    return summary;
  }
  const UncoupledModel<double> model = identifier.Estimate();
  const ParameterCovariance scatter = ScatterAbout(ToVector(model), last_part);
  const double inertia_std = std::sqrt(scatter(kInertia, kInertia));
  if (std::string why = WhyUnusable(model, inertia_std); !why.empty()) {
    summary.message = std::move(why);
    return summary;
  }
  summary.model = model;
  summary.covariance = scatter;
  summary.usable = true;
  summary.message = fmt::format("Adaptive law, one pass over {} samples.", n);
  AddCaveats(last_part, InertiaStep(model, segments), &summary);
  return summary;
}

}  // namespace fathom
