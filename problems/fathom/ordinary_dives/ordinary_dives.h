// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/ordinary_dives/dive_stretches.h"
#include "fathom/ordinary_dives/ordinary_knowledge.h"
#include "fathom/signal/segment.h"
#include "fathom/vehicle/fitted_model.h"

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Logs of ordinary dives, and the model that they are judged by.
struct OrdinaryRequest {
  FittedModel model;
  std::string name;               // of the model's file or logs, for messages
  std::vector<std::string> logs;  // their paths
  std::string data_flags;  // how else a command names them to read the same, " --correct=p:-1"
  std::vector<TimeInterval> spans;          // of each, held-out data included: first and last stamp
  std::vector<Segment> segments;            // of all logs, of one DOF
  std::vector<std::size_t> log_of_segment;  // an index into `logs` for each
};

// A stretch of a log, and what it tells.
struct OrdinaryStretch {
  DiveStretch stretch;
  std::size_t log_index = 0;
  TimeInterval time;  // stamps of the log [s]
  OrdinaryKnowledge alone;

  // Which stretch is chosen as the 1st, 2nd ..., and what those so far tell together; 0: not
  // chosen.
  int place = 0;
  OrdinaryKnowledge together;

  double Length() const { return time.to - time.from; }
};

enum class RemedyKind {
  kMoreOfTheSame,  // twice as much of these dives
  kManoeuvre,      // a minute of a simple manoeuvre beside them
  kPosition,       // the position logged too, and the fit made to it
  kFasterRate      // velocities four times as often
};

// "more_of_the_same", "manoeuvre", "position", "faster_rate".
std::string_view Name(RemedyKind kind);

// What would make the weakest parameter better known, and how well: half a 95 % interval by size.
struct Remedy {
  RemedyKind kind = RemedyKind::kMoreOfTheSame;
  std::string words;  // what to do: "record velocities at 10 Hz instead of 2.5 Hz"
  double share = std::numeric_limits<double>::infinity();

  // Of a manoeuvre: after how many minutes of it the parameter is well known; 0: more than ten.
  int minutes = 0;
};

// Which stretches of ordinary dives tell the parameters: docs/plan.md, "Ordinary dives".
struct OrdinaryDives {
  // Whether those who know so much know about as much as all logs.
  bool DoesAsWellAsAll(const OrdinaryKnowledge& knowledge) const;

  // False: the logs together do not tell all parameters; nothing below is filled in.
  bool IsUsable() const { return message.empty(); }
  std::string message = "JudgeDives() was not called.";

  std::vector<OrdinaryParameter> parameters;
  std::vector<OrdinaryStretch> stretches;  // in the order of logs and time
  std::vector<std::size_t> chosen;         // indices of stretches: the 1st, 2nd ...
  OrdinaryKnowledge all;                   // by all logs, uncut
  std::vector<Remedy> remedies;            // of the weakest parameter by all logs, best first

  double duration = 0.0;     // of all segments [s]
  double rate = 0.0;         // of the samples [Hz]
  bool is_position = false;  // the fit is made to displacements
  double noise = 0.0;        // of one sample of what the fit is made to
  double neighbour_correlation = 0.0;

  // Half intervals by size: beyond the first a parameter is open, below the second well known.
  static constexpr double kOpen = 0.5;
  static constexpr double kWellKnown = 0.2;

  // Correlation of neighbouring samples' noise beyond which they err alike.
  static constexpr double kAlike = 0.3;

  // The chosen stretches do once each interval is at most this times that of all logs, or well
  // known.
  static constexpr double kEnough = 1.25;
};

}  // namespace fathom
