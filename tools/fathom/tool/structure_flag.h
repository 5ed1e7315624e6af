// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_identification.h"

#include <gflags/gflags_declare.h>

// The flag of tools that let the structure of a coupled model be chosen.
DECLARE_string(structure);

namespace fathom {

// CoupledOptionsFromFlags() with the structure that --structure names. Throws InputError as there,
// and for a name that is none.
CoupledIdentificationOptions StructuredOptionsFromFlags();

}  // namespace fathom
