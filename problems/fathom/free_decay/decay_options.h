// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/decay_stretch.h"

#include <string>
#include <vector>

namespace fathom {

struct FreeDecayOptions {
  DecayOutput output = DecayOutput::kVelocity;

  // Whether something pulls the vehicle back to where it rests: then c is free and d is 0, as the
  // place of rest takes it up. Else d is free and c is 0.
  bool has_stiffness = false;

  double huber_k = 3.0;      // residuals beyond so many standard deviations count less; above 0
  int max_noise_order = 60;  // of the autoregression that stands for the residuals' colour

  // Every broken rule, a sentence each; empty if the options can be used.
  std::vector<std::string> Problems() const;
};

}  // namespace fathom
