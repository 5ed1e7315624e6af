// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/structure_flag.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/tool/coupled_flags.h"
#include "fathom/tool/flag_values.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(structure,
              "auto",
              "Of --dofs, what is free: diagonal, coriolis, lift, symmetric, full, lopsided, or "
              "auto: as the data "
              "show.");
DEFINE_string(free,
              "",
              "Of --dofs, beside what --structure frees: inertia.sway.yaw,thrust_gain.port, as "
              "docs/coupled.md names them.");

namespace fathom {

CoupledIdentificationOptions StructuredOptionsFromFlags() {
  CoupledIdentificationOptions options = CoupledOptionsFromFlags();
  for (const std::string& name : SplitAtCommas(FLAGS_free)) {
    options.also_free.push_back(ParseFlag("free", name, ParseFreeEntry));
  }
  if (FLAGS_structure == "auto") {
    if (options.also_free.empty()) return options;
    throw InputError(
        "--free: goes with a structure that is given, expected --structure beside it: "
        "--structure=auto chooses for itself.");
  }
  options.structure = StandardStructureFromName(FLAGS_structure);
  if (!options.structure) {
    throw InputError(
        fmt::format("--structure: is {}, expected diagonal, coriolis, lift, symmetric, full, "
                    "lopsided or auto.",
                    Quoted(FLAGS_structure)));
  }
  return options;
}

}  // namespace fathom
