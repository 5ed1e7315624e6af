// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/identification.h"

#include "fathom/least_squares/least_squares.h"
#include "fathom/simulate/data_range.h"
#include "fathom/simulate/free_run.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

// The three summaries have these members in common.
template <typename Summary>
void TakeOver(const Summary& summary, Identification* identification) {
  identification->is_usable = summary.IsUsable();
  identification->message = summary.message;
  identification->fitted.model = summary.model;
  identification->fitted.covariance = summary.covariance;
  identification->fitted.caveats = summary.caveats;
}

}  // namespace

std::optional<PoorFit> PoorFitOf(const FittedModel& fitted) {
  if (fitted.train.nmae > kPoorFit) return PoorFit{fitted.train.nmae, "the motion"};
  if (fitted.held_out.nmae > kPoorFit) return PoorFit{fitted.held_out.nmae, "the held-out motion"};
  return std::nullopt;
}

// One that misses almost all of the motion is no model, whatever its intervals say.
std::string CaveatOn(const PoorFit& fit) {
  constexpr double kExplainsLittle = 0.8;
  if (fit.nmae > kExplainsLittle) {
    return fmt::format(
        "Simulated from the command alone, it misses {:.0f} % of {}: this model explains almost "
        "nothing of these data. Check the warnings first. If it was fitted to poses and is "
        "compared with velocities, check whether these agree (size of the markers, units).",
        100.0 * fit.nmae,
        fit.motion);
  }
  return fmt::format(
      "The fit is poor: simulated from the command alone, it misses {:.0f} % of {}. Check "
      "the warnings first. Then run fathom_diagnose on this log: it looks for what the model "
      "lacks.",
      100.0 * fit.nmae,
      fit.motion);
}

void ScoreByFreeRuns(const Signals& scored, FittedModel* fitted) {
  fitted->train = FiguresOf({fitted->model}, scored.train);
  fitted->held_out = FiguresOf({fitted->model}, scored.held_out);
  fitted->range = RangeOf(scored.train);
  if (!scored.train.empty() && !std::isfinite(fitted->train.mae)) {
    fitted->caveats.push_back(
        "Its simulation from the command alone diverges, so it cannot predict.");
  }
  if (const auto poor = PoorFitOf(*fitted)) fitted->caveats.push_back(CaveatOn(*poor));
  if (!scored.held_out.empty() && !std::isfinite(fitted->held_out.mae)) {
    fitted->caveats.push_back(
        "Its simulation from the command alone diverges on the held-out data.");
  }
}

Identification Identify(const Signals& signals,
                        const Signals& scored,
                        Family family,
                        const IdentificationOptions& options) {
  Identification result;
  result.family = family;
  result.source = signals.source;
  result.fitted.dof = signals.dof;
  result.fitted.force_unit = signals.force_unit;
  if (signals.train.empty()) {
    result.message = IsAllHeldOut(signals)
                         ? kAllIsHeldOut
                         : "no training data are left. The notes say what was left out.";
    result.fitted.model = ModelFromVector(ParameterVector::Constant(std::nan("")));
    return result;
  }
  switch (family) {
    case Family::kLeastSquares: {
      const LeastSquaresSummary summary = FitLeastSquares(signals.train);
      TakeOver(summary, &result);
      result.condition_number = summary.condition_number;
      break;
    }
    case Family::kAdaptive: {
      const AdaptiveSummary summary = FitAdaptive(signals.train, options.adaptive);
      TakeOver(summary, &result);
      result.gains = summary.gains;
      break;
    }
    case Family::kOutputError: {
      OutputErrorOptions output_error = options.output_error;
      output_error.output = OutputOf(signals.train);
      const OutputErrorSummary summary = FitOutputError(signals.train, output_error);
      TakeOver(summary, &result);
      result.weighting = Name(summary.weighting);
      result.weighting_reason = summary.weighting_reason;
      // That of learned weights is of whitened residuals, that of poses of displacements.
      if (summary.IsUsable() && summary.weighting == Weighting::kPlain &&
          output_error.output == FittedOutput::kVelocity) {
        result.fitted.residual_autoregression = summary.evidence.noise.coefficients;
      }
      result.offsets = summary.offsets;
      if (summary.delay_is_open) {
        result.std_with_delay = summary.evidence.covariance_with_time_offset.diagonal().cwiseSqrt();
      }
      result.share = summary.evidence.share;
      result.condition_number = summary.evidence.condition_number;
      break;
    }
    case Family::kJoint:
      LOG(FATAL) << "The joint refinement takes corners, not signals.";
  }
  if (!result.is_usable) return result;
  ScoreByFreeRuns(scored, &result.fitted);
  return result;
}

}  // namespace fathom
