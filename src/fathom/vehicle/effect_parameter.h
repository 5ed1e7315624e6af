// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/scales.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A kind of number: its unit in words, and how large such a number naturally is on a given log, as
// powers of the force that was commanded (RMS), the speed reached (RMS) and one second.
struct Quantity {
  std::string_view linear_unit;   // of surge, sway and heave: "N/m"
  std::string_view angular_unit;  // of roll, pitch and yaw: "N m/rad"
  double force = 0.0;
  double speed = 0.0;
  double time = 0.0;
};

// How a parameter's value is looked for before it is refined.
enum class Search {
  kAmount,          // the response is about proportional to it: one small probe tells
  kSize,            // an amount whose response changes shape with its size: tried at several sizes
  kTimeOfRun,       // a time within the log: tried all along it
  kFrequencyOfRun,  // a frequency that the log can show: tried from its slowest to its fastest
  kShape            // a time constant that means nothing without an amount: tried at `trials`
};

// One number of an effect.
struct EffectParameter {
  std::string_view name;  // canonical, as in verdict files: "time_constant"
  Quantity quantity;
  double null;   // where the model is exactly the baseline; may be infinite. NaN: at any value, as
                 // long as the other parameters are at theirs
  double lower;  // bounds of a physical value
  double upper;
  Search search = Search::kAmount;
  // In natural sizes of the quantity: where to look (kSize, kShape), how far to probe (kAmount; a
  // fiftieth where empty).
  std::vector<double> trials = {};
  // What a synthesizer draws where no value is given.
  SizeRange drawn = {};
};

// Unit of a parameter of an effect along `dof`, where forces are given in `force_unit` ("N", "N m"
// or a log's own): "N/m".
std::string UnitOf(const Quantity& quantity, Dof dof, const std::string& force_unit);

}  // namespace fathom
