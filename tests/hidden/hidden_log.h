// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/extended_model.h"

#include <cstdint>
#include <string>
#include <vector>

#include "known_run.h"

namespace fathom::hidden {

enum class HiddenClass { kNothing, kOneEffect, kTwoEffects, kUnlisted };

// What one log is to hide; everything else follows from a seed.
struct LogPlan {
  HiddenClass hidden = HiddenClass::kNothing;
  std::vector<const Effect*> effects;
  int number = 0;  // of its kind

  // "thruster_lag.3", "nothing.17", "sensor_lag+thrust_curve.0"
  std::string Name() const;
};

// What the diagnosis never sees.
struct Truth {
  ExtendedModel model;  // of the DOF; with what is hidden
  KnownNoise noise;
  double train_from = 0.0, train_to = 0.0;  // log time [s]
  double held_out_to = 0.0;       // held out from train_to to here; at most train_to: none
  std::vector<double> signature;  // of each effect alone, SignatureOf() [-]
  std::string setup;  // "yaw, prbs, 312 s, 12 Hz, noise 2.1 % AR 0.7, poses, turbulence"
};

struct HiddenLog {
  LogPlan plan;
  Dof dof = Dof::kSurge;
  Log log;
  Truth truth;
};

// A pure function of the plan's name and the seed.
HiddenLog DrawHiddenLog(const LogPlan& plan, std::uint64_t seed);

// "thruster_lag", "velocity_coupling(sway)": as Candidate::label.
std::string LabelOf(const ActiveEffect& effect);

}  // namespace fathom::hidden
