// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/diagnosis/fit/identified_model.h"
#include "fathom/diagnosis/fit/started_model.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// Of the inertia that the measured motion shows, or a baseline does: beyond it a fit has run away
// from any motion.
inline constexpr double kRunAway = 1e3;

// Segments of which a diagnosis can be made.
struct Prepared {
  TrainingData data;
  std::vector<MeasuredSegment> thinned;  // SearchDataOf() the same
  std::vector<MeasuredSegment> held_out;

  StructureFit baseline;  // FitBaseline(): what causes are weighed against
  StartedModel users;     // UsersModel(), or the baseline: what free runs are judged against

  // Where the momentum along the measured motion puts the inertia [kg] or [kg m^2].
  double inertia_by_momentum = 0.0;

  // False where output error finds no baseline, or one that has run away from the motion, or the
  // search for it stopped before it arrived: then both models are MomentumBalance's, to start from,
  // and mean nothing.
  bool has_baseline = true;
  std::string why_no_baseline = {};  // NoBaseline() or that it did not converge
};

struct Preparation {
  int num_outliers = 0;              // single samples that were taken out of the training data
  double duration = 0.0;             // of all training data [s]
  double used = 0.0;                 // of the Excerpt() that the diagnosis takes of them [s]
  std::string message;               // why there can be no diagnosis; empty if there can
  std::optional<Prepared> prepared;  // there if no message is
};

// Why there is no diagnosis where there is no baseline and nothing is named.
std::string NoBaseline(Dof dof);

// The same where the search for it took all steps that it may and did not arrive.
std::string NotConverged(Dof dof);

// Takes an Excerpt() of what is not held out, an hour and 120 000 samples at most, and outliers out
// of that, fits the baseline to the rest along `dof`, and thins it. `identified`: the user's model;
// absent: output error's with plain weights.
Preparation Prepare(const MeasuredSegments& segments,
                    Dof dof,
                    const std::optional<IdentifiedModel>& identified = std::nullopt);

}  // namespace fathom
