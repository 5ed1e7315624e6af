// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/fit_adaptive.h"
#include "fathom/identification/family.h"
#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/output_error/output_error.h"
#include "fathom/signal/signals.h"
#include "fathom/vehicle/fitted_model.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

struct IdentificationOptions {
  AdaptiveOptions adaptive;
  OutputErrorOptions output_error;  // its output follows the source
  JointOptions joint;
};

// What one family made of one DOF's signals.
struct Identification {
  Family family = Family::kOutputError;
  Source source = Source::kPoseEstimator;
  bool is_usable = false;
  std::string message;  // why it ended as it did, for a person
  FittedModel fitted;   // its figures by free runs; NaN where not usable

  // Of joint alone: the family whose model stands in for a refinement that is none; OrBestGuess().
  std::optional<Family> stand_in;

  // Of output error alone, else empty: "plain" or "learned"; and for a person why not as asked.
  std::string weighting;
  std::string weighting_reason;

  // Of the adaptive law alone: those that were used, given or chosen.
  std::optional<AdaptiveGains> gains;

  // Of output error alone: by OutputErrorOptions::offsets.
  std::vector<OutputErrorSummary::Offset> offsets;

  // Of output error alone, where a caveat says that the data do not tell a delay of the command:
  // the standard deviations with an unknown delay. Infinite: nothing is known then.
  std::optional<ParameterVector> std_with_delay;

  // How well the log excites each parameter: the share of its signature that the others cannot
  // imitate, 0 to 1, and the condition number of all four. NaN where the family does not compute
  // it.
  ParameterVector share = ParameterVector::Constant(std::numeric_limits<double>::quiet_NaN());
  double condition_number = std::numeric_limits<double>::quiet_NaN();
};

// Fits one family to signals.train and scores it by free runs: on `scored`'s training segments and
// on its held-out ones. `scored` is `signals` itself, or the same DOF from a better source, so that
// models from several sources are measured with one yardstick.
//
// A fit that does not work does not throw: see the result. Throws InputError for broken options.
// `family` is one of kSignalFamilies.
Identification Identify(const Signals& signals,
                        const Signals& scored,
                        Family family,
                        const IdentificationOptions& options = {});

// A model whose free runs miss more of some motion than kPoorFit.
struct PoorFit {
  double nmae = 0.0;
  std::string motion;  // "the motion", "the held-out motion"
};

// Of the data that it was fitted to, else of those that were held out; nothing where both are well.
std::optional<PoorFit> PoorFitOf(const FittedModel& fitted);
std::string CaveatOn(const PoorFit& fit);

// The figures of a model by free runs over `scored`, the range of its training data, and caveats
// where the figures are bad.
void ScoreByFreeRuns(const Signals& scored, FittedModel* fitted);

}  // namespace fathom
