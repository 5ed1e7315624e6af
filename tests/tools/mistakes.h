// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "sound_log.h"

namespace fathom {

// What people do to their logs, each to a sound one; docs/findings.md, "The table of mistakes".

// The force in another unit: so many times the number in newton.
void ScaleForce(double factor, LogNumbers* log);

// The speed in another unit: so many times the number in m/s.
void ScaleSpeed(double factor, LogNumbers* log);

// The force as the pulse width of a motor controller [us], which stops at 1500.
void WritePulseWidths(LogNumbers* log);

// A DVL without lock writes zeros: 18 % of the rows, in runs of nine.
void LoseLock(LogNumbers* log);

// The sensor stands still from 40 s to 100 s.
void GetStuck(LogNumbers* log);

// "No reading" as the least 16-bit number of a millimetre a second, in 12 rows.
void WriteSentinels(LogNumbers* log);

// A value every 2 s, held in between.
void HoldSamples(LogNumbers* log);

// The 30 s from 20 s on come again from 90 s on.
void RepeatABlock(LogNumbers* log);

// The column holds accelerations, by central differences of the speed averaged over 0.5 s.
void WriteAccelerations(LogNumbers* log);

}  // namespace fathom
