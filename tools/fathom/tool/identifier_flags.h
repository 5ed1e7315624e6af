// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/identification/identification.h"
#include "fathom/tool/adaptive_flags.h"
#include "fathom/tool/log_flags.h"

#include <string>

#include <gflags/gflags_declare.h>

// Flags that the identifying tools share.
DECLARE_double(huber);
DECLARE_double(shooting_window);
DECLARE_string(weighting);

namespace fathom {

// Options of the families as --gains, --integrator, --huber, --shooting_window and --weighting say.
// Throws InputError for a value that cannot be used.
IdentificationOptions IdentificationOptionsFromFlags();

}  // namespace fathom
