// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_identification.h"

#include <string>
#include <vector>

namespace fathom {

// The options of coupled models, as the tools' flags have them: names of DOFs, the name of a
// structure or "auto", entries that are free beside a structure that is given, the window [s].
// Throws InputError for what cannot be used.
CoupledIdentificationOptions CoupledOptions(const std::vector<std::string>& dofs,
                                            const std::string& structure,
                                            const std::vector<std::string>& free,
                                            double window);

}  // namespace fathom
