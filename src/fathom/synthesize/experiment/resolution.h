// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// Of every stamp that is written [s].
inline constexpr double kStampResolution = 1e-6;

// The multiple of `resolution` nearest to `value`; the value itself where the resolution is 0. A
// resolution such as 0.001 gives the double nearest to the decimal, which prints in few digits.
double RoundTo(double value, double resolution);

}  // namespace fathom
