// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/coupled/coupled_identification.h"
#include "fathom/log/log.h"

#include <optional>
#include <span>
#include <vector>

#include <gflags/gflags_declare.h>

// Flags of tools that take several DOFs together.
DECLARE_string(dofs);
DECLARE_double(window);

namespace fathom {

// Whether --dofs asks for a model of several.
bool IsCoupledAsked();

// Where no DOF is given and a log names several: throws InputError that names --dofs too, which
// takes them as one motion.
void RequireDofOrDofs(std::span<const Log> logs, std::optional<Dof> given);

// Throws InputError for a flag that says nothing of what was asked for: with --dofs one of
// `of_one_dof`, which only a model of one DOF heeds, without it --structure or --window.
void RequireFlagsOfOneKind(const std::vector<const char*>& of_one_dof);

// What these flags say; the structure is open. Throws InputError for names that are none, and a DOF
// named twice.
CoupledIdentificationOptions CoupledOptionsFromFlags();

}  // namespace fathom
