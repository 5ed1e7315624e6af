// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// How long the run is that tools advise after a log of so many seconds: 60 to 300 s, of whole tens.
double HintedDuration(double log_duration);

}  // namespace fathom
