// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/input_error.h"
#include "fathom/comparison/identification.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <string>
#include <vector>

#include <gflags/gflags_declare.h>

// Flags that the identifying tools share.
DECLARE_string(log);
DECLARE_string(velocity);
DECLARE_string(gains);
DECLARE_string(integrator);
DECLARE_double(huber);
DECLARE_double(shooting_window);

namespace fathom {

// Splits at commas; empty for an empty text.
std::vector<std::string> SplitAtCommas(const std::string& text);

// parse(text), with the flag's name before what it says of a text it cannot use.
template <typename Parse>
auto ParseFlag(const std::string& flag, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const InputError& error) {
    throw InputError("--" + flag + ": " + error.what());
  }
}

// Options of the families as --gains, --integrator, --huber and --shooting_window say. Throws
// InputError for a value that cannot be used.
IdentificationOptions IdentificationOptionsFromFlags();

// Reads --log (with --velocity), turning thruster speeds into forces where the log's vehicle file
// says how, and prints the reader's remarks to stderr.
// `may_lack_motion` as in ReadLogOptions.
Log ReadLogFromFlags(const std::string& path, std::optional<Dof> dof, bool may_lack_motion = false);

}  // namespace fathom
