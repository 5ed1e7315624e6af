// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/held_command.h"
#include "fathom/log/log.h"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Where the motion comes from: velocity.csv, or the derivative of pose.csv.
enum class Source { kPoseEstimator, kCamera };

// "pose_estimator" or "camera".
std::string_view Name(Source source);

// Throws InputError, listing the names there are, in the form of ParseDof().
Source ParseSource(const std::string& name);

// One DOF over one unbroken stretch of a log. The vectors over `time` have its length.
struct Segment {
  std::vector<double> time;      // stamps of the motion stream [s], strictly increasing
  std::vector<double> velocity;  // as measured, or derived from the poses [m/s] or [rad/s]
  std::vector<double> position;  // displacement along the DOF [m] or [rad]; empty without poses
  HeldCommand command;           // at its own stamps

  // Velocity at the first stamp, by a local polynomial over the samples behind it, so that the
  // noise of one sample does not colour a whole free run. NaN if there are too few [m/s] or
  // [rad/s].
  double initial_velocity = std::numeric_limits<double>::quiet_NaN();

  // For the equation-error families (least squares): both sides of docs/models.md (2) through the
  // same Savitzky-Golay derivative filter, so that neither lags or is smoothed more than the other:
  // derivatives of the velocity, of the displacement, of the integral of v|v| and of the command's
  // impulse (docs/signal.md (3)). NaN near an end of the data, where the filter's window is
  // one-sided and its noise several times larger.
  std::vector<double> acceleration;       // [m/s^2] or [rad/s^2]
  std::vector<double> smoothed_velocity;  // [m/s] or [rad/s]
  std::vector<double> smoothed_force;     // [N] or [N m]
  std::vector<double> smoothed_square;    // v|v| [m^2/s^2]; empty: that of smoothed_velocity
};

// One DOF of a log, ready for an identifier.
struct Signals {
  Dof dof = Dof::kSurge;
  Source source = Source::kPoseEstimator;
  std::string force_unit;            // "N", "N m", or the log's command_unit
  std::vector<Segment> train;        // outside the held-out intervals; may be empty
  std::vector<Segment> held_out;     // inside them
  std::vector<std::string> remarks;  // what was left out, counted, a sentence each
};

struct SignalsOptions {
  Source source = Source::kPoseEstimator;

  // A silence of the motion stream longer than this starts a new segment [s]. Above 0.
  double longest_gap = 30.0;

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

// Adds the segments and remarks of another log, of the same DOF, source and unit.
void Append(const Signals& more, Signals* signals);

}  // namespace fathom
