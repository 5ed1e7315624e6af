// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/scales.h"

#include <cmath>

// Natural units of effects' sizes, docs/synthesize.md: products of the scales of an experiment.
namespace fathom::natural {

inline double One(const NaturalScales&) { return 1.0; }
inline double Force(const NaturalScales& n) { return n.own.force; }
inline double PeakForce(const NaturalScales& n) { return n.own.peak_force; }
inline double ForceRate(const NaturalScales& n) { return n.own.force_rate; }
inline double Speed(const NaturalScales& n) { return n.own.speed; }
inline double Place(const NaturalScales& n) { return n.own.place; }
inline double Length(const NaturalScales& n) { return n.own.length; }
inline double Duration(const NaturalScales& n) { return n.own.duration; }
inline double PerDuration(const NaturalScales& n) { return 1.0 / n.own.duration; }
inline double PerForce(const NaturalScales& n) { return 1.0 / n.own.force; }
inline double ForceDrift(const NaturalScales& n) { return n.own.force / n.own.duration; }
inline double Inflow(const NaturalScales& n) { return std::sqrt(n.own.force) / n.own.speed; }
inline double LinearDrag(const NaturalScales& n) { return n.own.force / n.own.speed; }
inline double PowerDrag(const NaturalScales& n) { return n.own.force / std::pow(n.own.speed, 1.5); }
inline double CubicDrag(const NaturalScales& n) { return n.own.force / std::pow(n.own.speed, 3.0); }
inline double WashDrag(const NaturalScales& n) { return 1.0 / (n.own.speed * n.own.speed); }
inline double Stiffness(const NaturalScales& n) { return n.own.force / n.own.length; }
// As a spring at small angles; a moment no larger than the command's where angles are large.
inline double RightingMoment(const NaturalScales& n) {
  return n.own.force / std::fmin(n.own.length, 1.0);
}
inline double Coupling(const NaturalScales& n) { return n.own.force / n.partner.speed; }
inline double Coriolis(const NaturalScales& n) {
  return n.own.force / (n.partner.speed * n.yaw.speed);
}
inline double Crosstalk(const NaturalScales& n) { return n.own.force / n.partner.force; }
inline double Arm(const NaturalScales& n) { return n.own.speed / n.partner.speed; }

}  // namespace fathom::natural
