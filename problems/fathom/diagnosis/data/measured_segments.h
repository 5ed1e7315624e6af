// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/filters/dominant_tone.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/effect_simulation.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// One unbroken stretch of a log along one DOF: what drove it and what was measured of it.
struct MeasuredSegment {
  std::string log;  // its name, which no other of the logs has
  bool is_held_out = false;
  std::shared_ptr<const EffectInputs> inputs;  // of the whole log
  Tone command_tone;                           // DominantTone() of their command
  OutputStamps stamps;
  std::vector<double> velocity;               // at stamps.velocity [m/s] or [rad/s]
  std::vector<double> displacement;           // at stamps.displacement [m] or [rad]
  std::vector<double> displacement_variance;  // VarianceOverUsual() of its noise; empty: all alike
  InitialState initial;                       // guessed from the first samples

  double duration() const { return stamps.Duration(); }  // [s]
};

struct MeasuredSegments {
  std::vector<MeasuredSegment> all;
  std::vector<std::string> logs;  // their names, each told from the others, in their order
  std::string force_unit;
  bool has_velocity = true;
  bool has_displacement = false;
  bool poses_lose_motion = false;  // of some log, as its remark says (kLostMotion)
  std::vector<Dof> partners;       // other DOFs whose velocity is measured in every log
  std::vector<std::string> remarks;
};

// Velocities where every log has them, displacements from poses where every log has them and the
// DOF's axis keeps its direction. Segments at silences of over 30 s and at the ends of held-out
// intervals.
//
// Throws InputError if a log has no command or no motion of this DOF, if their command units
// differ, or if nothing is left to train on.
MeasuredSegments MeasuredSegmentsOf(std::span<const Log> logs, Dof dof);

// Lets the segment start at `time`, one of its stamps or before them, its state guessed anew from
// the samples from there on.
void RestartAt(double time, MeasuredSegment* segment);

// As the families take it: velocities, or the derivative of the displacements.
Segment PlainSegment(const MeasuredSegment& segment);

}  // namespace fathom
