// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/effect.h"

#include <string>

namespace fathom {

// One number of a CoupledModel that may be identified, as files and reports name it:
//
//   inertia.surge                 M_11
//   inertia.sway.yaw              M_26 = M_62, one number
//   linear_damping.yaw            D_L,66
//   linear_damping.sway.yaw       D_L,26: along sway, by r
//   quadratic_damping.heave       D_Q,33        quadratic_damping.yaw.sway
//   righting_moment.roll          K_p           righting_moment.pitch
//   net_buoyancy                  b
//   offset.yaw                    o_6
//   thrust_gain.port              of the thruster or shaft `port`
//   thrust_angle                  a, by which the forces of wrench and thrusters are turned about z
//   time_offset                   by which all commands come late
//   thruster_lag                  time constant of the forces of wrench and thrusters
//   lift.sway.yaw                 L_26: along sway, by u r
//   fin_force.rudder              f of the fin `rudder`
//   fin_race.rudder               k: what the race adds to the square of its speed
//   fin_neutral.rudder            the angle at which it is straight
//   fin_stuck.rudder              the angle that it has whatever is commanded
//   fin_lag.rudder                time constant with which its angle follows the command
//   fin_rate_limit.rudder         how fast its angle follows the command at most
//   fin_stall.rudder              the angle of attack from which its lift grows no more
//   coulomb_friction.surge        an effect along a DOF, coupled_effects.h
//   thrust_dead_zone              one of the thrust of every thruster
//   current.north.dive_3          along x of the world, in the log `dive_3`; current.east.dive_3
//   offset.yaw.dive_3             what the log `dive_3` adds to offset.yaw
struct FreeEntry {
  enum class Kind {
    kInertia,
    kLinearDamping,
    kQuadraticDamping,
    kRightingMoment,  // row: roll or pitch
    kNetBuoyancy,
    kOffset,
    kThrustGain,
    kThrustAngle,
    kTimeOffset,
    kThrusterLag,
    kLift,
    kFinForce,
    kFinRace,
    kFinNeutral,
    kFinStuck,
    kFinLag,
    kFinRateLimit,
    kFinStall,
    kEffect,
    kThrusterEffect,
    kCurrent,  // row: surge for north, sway for east
    kRunOffset,
  };
  Kind kind = Kind::kInertia;
  Dof row = Dof::kSurge;  // along which it acts; the lower one of a pair in the inertia
  Dof column =
      Dof::kSurge;  // by whose velocity or acceleration; the row itself where there is none
  // The thruster of a thrust gain, the fin of a fin's number, the log of a run's number.
  std::string actuator = {};
  const Effect* effect = nullptr;  // of kEffect and kThrusterEffect; of the catalogue

  bool operator==(const FreeEntry&) const = default;
};

FreeEntry InertiaEntry(Dof a, Dof b);  // in either order
FreeEntry LinearDampingEntry(Dof row, Dof column);
FreeEntry QuadraticDampingEntry(Dof row, Dof column);
FreeEntry OffsetEntry(Dof row);
FreeEntry RightingMomentEntry(Dof row);
FreeEntry NetBuoyancyEntry();
FreeEntry ThrustGainEntry(const std::string& thruster);
FreeEntry ThrustAngleEntry();
FreeEntry TimeOffsetEntry();
FreeEntry ThrusterLagEntry();
FreeEntry LiftEntry(Dof row, Dof column);
FreeEntry FinForceEntry(const std::string& fin);
FreeEntry FinRaceEntry(const std::string& fin);
FreeEntry FinNeutralEntry(const std::string& fin);
FreeEntry FinStuckEntry(const std::string& fin);
FreeEntry FinLagEntry(const std::string& fin);
FreeEntry CurrentEntry(Dof axis, const std::string& log);
FreeEntry RunOffsetEntry(Dof row, const std::string& log);
FreeEntry FinRateLimitEntry(const std::string& fin);
FreeEntry FinStallEntry(const std::string& fin);
FreeEntry EffectEntry(const Effect& effect, Dof row);
FreeEntry ThrusterEffectEntry(const Effect& effect);

// Whether it belongs to a thruster, a fin or all of them, or to a log, instead of a row and a
// column.
bool IsOfActuator(const FreeEntry& entry);

// Whether it is a time constant, which is above 0 s.
bool IsLag(const FreeEntry& entry);

// Whether it holds in one log alone.
bool IsOfRun(const FreeEntry& entry);

// Whether it is a bound, above 0, which is infinite where it is not there: of a fin's rate or of
// its angle of attack.
bool IsLimit(const FreeEntry& entry);

// Whether it is above 0 in every model: a time constant, a bound, or an effect that takes energy or
// thrust.
bool IsPositive(const FreeEntry& entry);

// Whether it is an effect of the catalogue.
bool IsEffect(const FreeEntry& entry);

// The least that it is in a model of a body; minus infinity of a coupling.
double LowerBoundOf(const FreeEntry& entry);

// Whether a model of a body may hold it at this value: a friction is no drive, a bound is above 0,
// and a fin has stalled at a right angle.
bool MayBe(const FreeEntry& entry, double value);

// Whether it says how late a command acts: an offset or a lag.
bool IsLateness(const FreeEntry& entry);

// Which of kParameterInfo, the parameters of a model of one DOF, it is along its own DOF; -1 of a
// coupling, and of what a model of one DOF has not.
int ParameterOf(const FreeEntry& entry);

}  // namespace fathom
