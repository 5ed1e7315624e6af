// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// The least inertia that a fit may try, of the baseline's or output error's, whichever is smaller.
// Far below the truth a run takes ever more steps.
inline constexpr double kLeastInertia = 0.1;

// The same of output error's where the baseline leaves the inertia open: it is no measure then.
inline constexpr double kLeastInertiaIfOpen = 0.01;

}  // namespace fathom
