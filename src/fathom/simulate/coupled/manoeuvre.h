// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// A standard manoeuvre of a vehicle; IMO MSC.137(76), ITTC 7.5-02-06-01.
struct Manoeuvre {
  enum class Kind {
    kTurningCircle,  // the rudder to one side, and held
    kZigzag,   // the rudder to one side and, whenever the heading reaches it, to the other one
    kStop,     // the thrust astern, or off; the rudder midships
    kSpiral,   // the rudder from starboard to port in steps and back, each until the turn is steady
    kPullOut,  // a steady turn to starboard, midships, a steady turn to port, midships
  };
  Kind kind = Kind::kTurningCircle;
  double angle = 0.0;       // of the rudder, above 0 [rad]; none of a stop
  double heading = 0.0;     // of a zigzag, above 0 [rad]
  double first_side = 1.0;  // of a circle and a zigzag: 1 to starboard, -1 to port
  double astern = 1.0;      // of a stop: share of the thrust ahead, at least 0; 0: off
};

// "turning_circle:35", "zigzag:10/10", "spiral:25", "pull_out:20" in degrees, "stop:100" in per
// cent of the thrust; the last three also without a number, which is then this one. A minus before
// the first number of a circle or a zigzag: to port first. Throws InputError, with what is
// expected, for anything else.
Manoeuvre ParseManoeuvre(std::string_view text);

}  // namespace fathom
