// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_identification.h"

#include <gflags/gflags_declare.h>

// The flags of tools that let the structure of a coupled model be chosen.
DECLARE_string(structure);
DECLARE_string(free);

namespace fathom {

// CoupledOptionsFromFlags() with the structure that --structure names and what --free frees beside
// it. Throws InputError as there, for a name that is none, and for --free without a structure.
CoupledIdentificationOptions StructuredOptionsFromFlags();

}  // namespace fathom
