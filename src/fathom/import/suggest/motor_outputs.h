// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/boat_outputs.h"
#include "fathom/import/suggest/channel_facts.h"
#include "fathom/import/suggest/suggested_map.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// The output that drives a motor.
struct MotorOutput {
  int output = 0;  // from 1 on; 0: none is known
  FieldPlace place;
  std::optional<bool> is_reversed;   // nothing: not known
  std::optional<int> function = {};  // SERVOn_FUNCTION, where it is no motor's
  double middle = 1500.0;            // the pulse at rest [us]
};

// How ArduPilot's outputs drive the motors, by its settings SERVOn_FUNCTION (33 to 40: motor 1 to
// 8; 82 to 85: motor 9 to 12) and MOT_n_DIRECTION. Any output can drive any motor; the others are
// lights, a gripper, the tilt of a camera.
struct MotorOutputs {
  std::vector<MotorOutput> motors;  // motor 1 and on; without settings, output 1 and on
  BoatOutputs boat;                 // its throttle is the only motor of a vehicle that has no other

  // What the settings leave open, a sentence without its full stop; empty: nothing.
  std::string unknown;
};

// `field`: of the pulses of an output, '#' for its number, in the first of the channels that has
// it. Motors behind the last one whose output ever sends a pulse are left out.
MotorOutputs MotorOutputsOf(const Recording& recording,
                            const std::vector<std::string>& channels,
                            const std::string& field);

// The lines of the map for so many of the motors. `channel`: the one that the command names.
std::string ThrusterLines(const MotorOutputs& outputs,
                          int num_thrusters,
                          const std::string& channel);

// Says first in the map, and in `unknown`, what the settings leave open: it is then not ready.
void TellUnknownOutputs(const MotorOutputs& outputs, SuggestedMap* map);

}  // namespace fathom
