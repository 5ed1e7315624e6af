// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/segment.h"
#include "fathom/signal/sources/source.h"
#include "fathom/signal/split_at_gaps.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// One DOF of a log, ready for an identifier.
struct Signals {
  Dof dof = Dof::kSurge;
  Source source = Source::kPoseEstimator;
  std::string force_unit;            // "N", "N m", or the log's command_unit
  std::vector<Segment> train;        // outside the held-out intervals; may be empty
  std::vector<Segment> held_out;     // inside them
  std::vector<std::string> remarks;  // what was left out, counted, a sentence each
};

// A piece of a log with fewer samples is left out.
inline constexpr std::size_t kFewestOfSegment = 10;

struct SignalsOptions {
  Source source = Source::kPoseEstimator;

  // A silence of the motion stream longer than this starts a new segment [s]. Above 0.
  double longest_gap = kLongestGap;

  // Savitzky-Golay: window [s] (0: chosen from the data's rate) and order of the polynomial.
  double window = 0.0;
  int order = 3;

  // False: held-out intervals are trained on like the rest.
  bool split_held_out = true;
};

// Throws InputError if the log lacks a stream or column that this DOF and source need.
Signals SignalsOf(const Log& log, Dof dof, const SignalsOptions& options = {});

// What is wrong with a log of which IsAllHeldOut(), the same words in every family.
inline constexpr std::string_view kAllIsHeldOut =
    "nothing is left to train on: the held-out intervals take all of the data.";
bool IsAllHeldOut(const Signals& signals);

}  // namespace fathom
