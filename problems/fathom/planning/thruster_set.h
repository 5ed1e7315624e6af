// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/plan_limits.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <limits>
#include <string>
#include <vector>

namespace fathom {

// What is known of the supply and the use of thrusters.
struct ThrusterSupply {
  // [V]; NaN: that of the tables, where they hold one.
  double voltage = std::numeric_limits<double>::quiet_NaN();
  double thruster_force = PlanLimits::kNoLimit;  // greatest of each thruster, either way [N]
};

// The thrusters of a vehicle and what each can give. Vectors are in the order of the vehicle file.
struct ThrusterSet {
  std::vector<std::string> names;
  std::vector<ValueRange> range;          // of each thrust; infinite: not known [N]
  std::vector<const ThrustTable*> table;  // of pulse widths, of each, in the Vehicle; else none
  double voltage = std::numeric_limits<double>::quiet_NaN();  // that the tables are read at [V]

  // Whether each of these thrusts [N] is within its range, rounding aside.
  bool Gives(const std::vector<double>& thrusts) const;

  // The same thrusts, those that rounding alone has put beyond an end of their range at this end.
  std::vector<double> WithoutRounding(std::vector<double> thrusts) const;

  bool HasPulses() const;

  // The pulse widths that give these thrusts [N], to whole microseconds [us]. Empty unless each
  // thruster has a table of them.
  std::vector<int> PulsesOf(const std::vector<double>& thrusts) const;
};

// What a plan takes of them: a row for each stamp, held until the next.
struct PlannedThrusts {
  std::vector<double> time;                 // [s]; the last one is the end
  std::vector<std::vector<double>> thrust;  // of each thruster [N]
};

// `name` stands for the vehicle file in messages; `vehicle` must outlive the result. Throws
// InputError where it has no thrusters, the tables hold no such voltage, or one tells no command
// for a thrust of 0.
ThrusterSet ThrustersOf(const ThrusterSupply& supply,
                        const Vehicle& vehicle,
                        const std::string& name);

}  // namespace fathom
