// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/coupled/coupled_identification.h"

#include <vector>

#include <gflags/gflags_declare.h>

// Flags of tools that take several DOFs together.
DECLARE_string(dofs);
DECLARE_string(structure);
DECLARE_double(window);

namespace fathom {

// Whether --dofs asks for a model of several.
bool IsCoupledAsked();

// What these flags say. Throws InputError for names that are none, and a DOF named twice.
CoupledIdentificationOptions CoupledOptionsFromFlags();

}  // namespace fathom
