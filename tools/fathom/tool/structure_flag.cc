// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/structure_flag.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/tool/coupled_flags.h"

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(structure,
              "auto",
              "Of --dofs, what is free: diagonal, coriolis, lift, symmetric, full, lopsided, or "
              "auto: as the data "
              "show.");

namespace fathom {

CoupledIdentificationOptions StructuredOptionsFromFlags() {
  CoupledIdentificationOptions options = CoupledOptionsFromFlags();
  if (FLAGS_structure == "auto") return options;
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
