// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

namespace fathom {

// A random function of a dimensionless time s, the same for the same realisation: mean 0, standard
// deviation 1 and correlation exp(-|s|) over all realisations, near normal.
//
//   sqrt(2 / n) sum_i cos(w_i s + phase_i),   w_i = tan(pi (u_i - 1/2)),  n = 64
//
// w has the Cauchy distribution, whose characteristic function is exp(-|s|). It can be asked at any
// time in any order, as effects ask; Turbulence is the same process as a sequence.
double RandomWaveAt(std::uint64_t realisation, double s);

}  // namespace fathom
