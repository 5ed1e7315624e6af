// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace fathom {

// A sentence of the library, which names options as the programs have them, "--held_out: ...", with
// the names that they have in Python, "held_out: ...". Commands to be typed stay as they are:
// "fathom_check --archive=dives".
std::string InPythonWords(const std::string& text);
std::vector<std::string> InPythonWords(const std::vector<std::string>& texts);

}  // namespace fathom
