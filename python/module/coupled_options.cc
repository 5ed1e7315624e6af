// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/coupled_options.h"

#include "fathom/base/quoted.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>

#include "module/arguments.h"
#include <fmt/format.h>

namespace fathom {

CoupledIdentificationOptions CoupledOptions(const std::vector<std::string>& dofs,
                                            const std::string& structure,
                                            const std::vector<std::string>& free,
                                            double window) {
  CoupledIdentificationOptions options;
  options.dofs = ParseList("dofs", dofs, ParseDof);
  if (options.dofs.empty()) throw InputError("dofs: is empty, expected several.");
  std::sort(options.dofs.begin(), options.dofs.end());
  if (structure != "auto") {
    options.structure = StandardStructureFromName(structure);
    if (!options.structure) {
      throw InputError(fmt::format(
          "structure: is {}, expected diagonal, coriolis, lift, symmetric, full, lopsided or auto.",
          Quoted(structure)));
    }
  }
  options.also_free = ParseList<FreeEntry>(
      "free", free, [](const std::string& name) { return ParseFreeEntry(name); });
  if (!free.empty() && !options.structure) {
    throw InputError(
        "free: goes with a structure that is given, expected one beside it: \"auto\" chooses for "
        "itself.");
  }
  options.fit.window = window;
  if (const auto problems = options.fit.Problems(); !problems.empty()) {
    throw InputError(problems.front() + ".");
  }
  return options;
}

}  // namespace fathom
