// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/effect_sizes.h"

#include <cmath>
#include <string_view>

#include <glog/logging.h>

namespace fathom {
namespace {

// The DOF itself, its partner, and yaw.
struct Natural {
  const Scales& own;
  const Scales& partner;
  const Scales& yaw;
};
using Unit = double (*)(const Natural&);

double One(const Natural&) { return 1.0; }
double Force(const Natural& n) { return n.own.force; }
double PeakForce(const Natural& n) { return n.own.peak_force; }
double ForceRate(const Natural& n) { return n.own.force_rate; }
double Speed(const Natural& n) { return n.own.speed; }
double Place(const Natural& n) { return n.own.place; }
double Length(const Natural& n) { return n.own.length; }
double Duration(const Natural& n) { return n.own.duration; }
double PerDuration(const Natural& n) { return 1.0 / n.own.duration; }
double PerForce(const Natural& n) { return 1.0 / n.own.force; }
double ForceDrift(const Natural& n) { return n.own.force / n.own.duration; }
double Inflow(const Natural& n) { return std::sqrt(n.own.force) / n.own.speed; }
double LinearDrag(const Natural& n) { return n.own.force / n.own.speed; }
double PowerDrag(const Natural& n) { return n.own.force / std::pow(n.own.speed, 1.5); }
double CubicDrag(const Natural& n) { return n.own.force / std::pow(n.own.speed, 3.0); }
double WashDrag(const Natural& n) { return 1.0 / (n.own.speed * n.own.speed); }
double Stiffness(const Natural& n) { return n.own.force / n.own.length; }
double Coupling(const Natural& n) { return n.own.force / n.partner.speed; }
double Coriolis(const Natural& n) { return n.own.force / (n.partner.speed * n.yaw.speed); }
double Crosstalk(const Natural& n) { return n.own.force / n.partner.force; }
double Arm(const Natural& n) { return n.own.speed / n.partner.speed; }

struct SizeRange {
  std::string_view effect;
  std::string_view parameter;
  double smallest;
  double largest;
  Unit unit;
  bool either_sign = false;
};

constexpr SizeRange kRanges[] = {
    {"time_offset", "offset", 0.1, 1.5, One, true},
    {"thrust_dead_zone", "width", 0.05, 0.6, Force},
    {"thrust_saturation", "limit", 0.25, 0.85, PeakForce},
    {"thrust_curve", "exponent", 0.5, 2.0, One},
    {"thrust_asymmetry", "reverse_loss", 0.05, 0.5, One},
    {"thrust_fade", "rate", 0.08, 0.6, PerDuration},
    {"thrust_step_loss", "loss", 0.08, 0.6, One},
    {"thrust_step_loss", "time", 0.2, 0.8, Duration},
    {"thrust_slew_limit", "rate", 0.5, 1.5, ForceRate},
    {"thruster_lag", "time_constant", 0.1, 2.0, One},
    {"thrust_inflow_loss", "coefficient", 0.05, 0.4, Inflow},
    {"damping_asymmetry", "ratio", 0.2, 2.0, One},
    {"cubic_damping", "coefficient", 0.1, 1.0, CubicDrag},
    {"coulomb_friction", "force", 0.03, 0.4, Force},
    {"steady_current", "speed", 0.05, 0.7, Speed, true},
    {"position_stiffness", "stiffness", 0.05, 0.6, Stiffness},
    {"buoyancy_step", "jump", 0.05, 0.6, Force, true},
    {"buoyancy_step", "time", 0.2, 0.8, Duration},
    {"buoyancy_drift", "slope", 0.08, 1.0, ForceDrift, true},
    {"periodic_force", "sine", 0.04, 0.5, Force, true},
    {"periodic_force", "cosine", 0.04, 0.5, Force, true},
    {"periodic_force", "frequency", 0.2, 2.0, One},
    {"fluid_memory", "coefficient", 0.2, 1.5, LinearDrag},
    {"fluid_memory", "time_constant", 0.6, 15.0, One},
    {"coriolis_coupling", "coefficient", 0.1, 0.8, Coriolis, true},
    {"velocity_coupling", "coefficient", 0.05, 0.6, Coupling, true},
    {"thrust_crosstalk", "gain", 0.05, 0.6, Crosstalk, true},
    {"sensor_misalignment", "angle", 0.04, 0.5, One, true},
    {"lever_arm", "arm", 0.05, 0.8, Arm, true},
    {"sensor_bias", "bias", 0.03, 0.5, Speed, true},
    {"sensor_lag", "time_constant", 0.1, 2.0, One},
    {"sensor_clock_offset", "offset", 0.1, 1.5, One, true},
    {"pose_scale", "error", 0.02, 0.3, One, true},
    {"marker_moved", "jump", 0.1, 2.0, Speed, true},
    {"marker_moved", "time", 0.2, 0.8, Duration},
    {"unlisted.thrust_backlash", "width", 0.1, 0.6, Force},
    {"unlisted.thrust_levels", "step", 0.3, 1.5, Force},
    {"unlisted.thruster_heat", "loss", 0.1, 0.6, PerForce},
    {"unlisted.thruster_heat", "time_constant", 10.0, 60.0, One},
    {"unlisted.thrust_wash_drag", "coefficient", 0.1, 0.5, WashDrag},
    {"unlisted.power_damping", "coefficient", 0.2, 2.0, PowerDrag},
    {"unlisted.place_bump", "force", 0.2, 1.0, Force, true},
    {"unlisted.place_bump", "place", 0.7, 1.2, Place},
    {"unlisted.place_bump", "width", 0.2, 0.8, Length},
    {"unlisted.slack_tether", "stiffness", 0.3, 2.0, Stiffness},
    {"unlisted.slack_tether", "length", 0.1, 0.8, Length},
    {"unlisted.wandering_current", "speed", 0.1, 0.6, Speed},
    {"unlisted.wandering_current", "correlation_time", 5.0, 40.0, One},
    {"unlisted.wandering_current", "realisation", 1.0, 1e6, One},
};

const SizeRange& RangeOf(std::string_view effect, std::string_view parameter) {
  for (const SizeRange& range : kRanges) {
    if (range.effect == effect && range.parameter == parameter) return range;
  }
  LOG(FATAL) << "no range of sizes for " << effect << "'s " << parameter;
}

}  // namespace

std::vector<double> DrawSizes(const Effect& effect,
                              Dof dof,
                              Dof partner,
                              const std::array<Scales, 6>& scales,
                              RandomStream& random) {
  const Natural natural = {scales[Index(dof)], scales[Index(partner)], scales[Index(Dof::kYaw)]};
  std::vector<double> values;
  for (const EffectParameter& parameter : effect.info().parameters) {
    const SizeRange& range = RangeOf(effect.info().name, parameter.name);
    const double size = range.smallest * std::pow(range.largest / range.smallest, random.Uniform());
    const double sign = random.Uniform() < 0.5 && range.either_sign ? -1.0 : 1.0;
    values.push_back(sign * size * range.unit(natural));
  }
  return values;
}

}  // namespace fathom
