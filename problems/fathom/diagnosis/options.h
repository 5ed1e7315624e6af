// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/judge/verdict_rules.h"
#include "fathom/diagnosis/search/search_options.h"
#include "fathom/findings/finding.h"
#include "fathom/vehicle/effect.h"
#include "fathom/vehicle/thruster.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fathom {

struct DiagnosisOptions {
  // Chance of naming anything at all where nothing is missing. In (0, 0.5].
  double false_alarm_rate = 0.05;

  // At most so many causes at once, 1 to 3.
  int most_causes = 3;

  // A rival is told apart from the named cause only if it is worse by this much: twice the
  // log-likelihood, after each one's own number of parameters is paid for.
  double separation = 8.0;

  // How long causes are searched where no model fits, as a multiple of the usual. Above 0.
  double effort = 1.0;

  // Of the draws behind thresholds and intervals.
  std::uint64_t seed = 1;

  // The effects that are tried; empty: EffectCatalogue().
  std::vector<const Effect*> effects;

  // Of the vehicle, to say which of them a crosstalk comes down to; empty: not known.
  std::vector<Thruster> thrusters;

  // The thresholds of a verdict, and how widely causes are searched. `hidden_scores --sweep` says
  // what each of them moves.
  VerdictRules rules = {};
  SearchOptions search = {};

  // Called with what the checks of the data found, before the search; may be empty.
  std::function<void(const std::vector<Finding>&)> on_findings;

  // One line for each rule that is broken; empty if these options can be used.
  std::vector<std::string> Problems() const;
};

}  // namespace fathom
