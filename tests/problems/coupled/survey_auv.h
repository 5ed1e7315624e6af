// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/entry_search.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/fin.h"

#include <array>
#include <string>
#include <vector>

namespace fathom {

// What is wrong with one fin of a survey AUV.
enum class FinFault { kNone, kDead, kStuck, kNeutral, kSlow, kLimited, kStalled };

// A survey AUV of six DOFs with four fins in a cross at its stern, drawn: its numbers, which fin a
// fault is of, and how far that is stuck off.
struct SurveyAuv {
  CoupledModel truth;
  std::array<Fin, 4> fins;  // upper, lower, port, starboard
  std::size_t faulty = 0;
  double stuck = 0.0;  // [rad], 3 to 12 degrees to either side
};
SurveyAuv DrawnSurveyAuv(unsigned seed);

// 3 degrees [rad].
inline constexpr double kNeutralOfSurvey = 0.05236;

// The time constant of a slow fin [s].
inline constexpr double kLagOfSurvey = 0.5;

// The rate of a fin that is limited [rad/s].
inline constexpr double kRateOfSurvey = 0.15;

// The angle of attack at which a fin stalls early [rad].
inline constexpr double kStallOfSurvey = 0.12;

// How the fins turn: steps by chance for a fit, or a zigzag, a circle and steps in depth.
enum class SurveyRun { kSteps, kManoeuvres };

// `duration` [s] at 10 Hz of velocities and attitude with white noise. Simulated by the plain
// simulator and the fins' law by angles, which share nothing with Fathom's.
CoupledData SurveyLog(
    const SurveyAuv& auv, FinFault fault, SurveyRun run, double duration, unsigned seed);

// What is known of it: the fins' forces, and the inertia off the diagonal.
EntrySearchOptions SearchOptionsOf(const SurveyAuv& auv);

// How often intervals of 95 % of a sound vehicle hold the truth, and how far its model misses
// unseen manoeuvres, in shares of how far the true model does.
struct SurveyFit {
  bool is_usable = false;
  std::string message;
  int num_numbers = 0, num_covered = 0;
  double miss_ratio = 0.0;
};
SurveyFit FitSurvey(unsigned seed);

// What the search names of a vehicle with a fault, and whether that is the fault and nothing else.
struct SurveyNaming {
  std::vector<std::string> named;
  std::vector<std::string> not_told_apart;
  bool is_right = false;  // the fault is among them
  double value = 0.0;     // of the fault, and its standard deviation [unit of the entry]
  double std = 0.0;
  int num_false = 0;  // others
};
SurveyNaming NameFault(unsigned seed, FinFault fault);

}  // namespace fathom
