// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_info.h"

// What is easily taken for one another, and the experiment that tells; docs/diagnosis.md. One that
// is not here needs nothing special.
namespace fathom {

// A lag, a delay or a ramp of the thrust, and of the sensor. Steps of one size would leave the ramp
// open.
inline constexpr Confusion kLateThrust = {
    "Steps of several sizes both ways, some seconds each: a lag rounds the corners, a delay "
    "shifts them, a ramp takes longer for larger steps."};
inline constexpr Confusion kLateReading = {kLateThrust.experiment};

// Which of two lags.
inline constexpr Confusion kWhichLag = {
    "Poses too, which have no lag of the speed sensor, or large steps, to speeds where quadratic "
    "drag matters: under linear drag it makes no difference which of the two lags."};

inline constexpr Confusion kSpeedAtRest = {
    "No velocity log can decide, because the two are identical at every speed. Log poses too.",
    false};

inline constexpr Confusion kSmallCommands = {
    "Small commands of both signs while the vehicle coasts, in both directions."};

inline constexpr Confusion kLargeCommands = {
    "Large commands at low speed: short full thrust from rest, both ways."};

inline constexpr Confusion kOneWay = {
    "Reversals while moving: full thrust against the motion, both ways."};

inline constexpr Confusion kDragOverSpeed = {
    "A range of speeds held for a while each, from very slow to full."};

inline constexpr Confusion kStepOrDrift = {
    "The same experiment again, longer, with a pause at rest."};

inline constexpr Confusion kSpringOrRighting = {
    "Tilt the vehicle by more than a radian: the moment of a spring keeps growing, a righting "
    "moment is largest at 90 degrees."};

inline constexpr Confusion kSpringOrDrift = {
    "Move away and return: the force of a spring returns with the position, a drift does not."};

inline constexpr Confusion kSpringOrStep = {
    "Move away and return: the force of a spring returns with the position, a step does not."};

}  // namespace fathom
