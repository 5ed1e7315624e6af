// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/channel_facts.h"
#include "fathom/vehicle/fin.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// An output of a boat, with the pulses of its settings SERVOn_MIN, _TRIM and _MAX [us].
struct BoatOutput {
  int output = 0;  // from 1 on
  FieldPlace place;
  double least = 0.0, middle = 0.0, most = 0.0;
  bool is_reversed = false;  // SERVOn_REVERSED: a command above 0 gives pulses below the middle
};

// How ArduPilot steers and drives a boat, by its settings SERVOn_FUNCTION: 26 (GroundSteering) and
// 70 (Throttle). A steering command above 0 is to starboard.
struct BoatOutputs {
  std::optional<BoatOutput> steering, throttle;
  std::vector<std::string> notes;  // what is not taken, and why: a clause each

  // What the settings leave open, a sentence without its full stop; empty: nothing.
  std::string unknown;
};

// `place_of`: where the pulses of an output stand; nothing where the log does not hold them.
BoatOutputs BoatOutputsOf(const Contents& contents,
                          const std::function<std::optional<FieldPlace>(int)>& place_of);

// The lines of a map for the steering, as an angle of the fin of the vehicle that steers it.
// `channel`: the one that the command names. `fins`: of the vehicle, where that is known.
std::string SteeringLines(const BoatOutputs& outputs,
                          std::span<const Fin> fins,
                          const std::string& channel);

}  // namespace fathom
