// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_identifier.h"

#include <gflags/gflags_declare.h>

// Flags of every tool that runs the adaptive law.
DECLARE_string(gains);
DECLARE_string(integrator);

namespace fathom {

// Options of the adaptive law as --gains and --integrator say; no gains where none are given.
// Throws InputError for a value that cannot be used.
AdaptiveOptions AdaptiveOptionsFromFlags();

}  // namespace fathom
