// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>
#include <string>

namespace fathom {

// Thrown when a file, flag or option given by the user cannot be used. The text is shown to that
// user as it stands: where the problem is (file, line, column), what was found, what was expected,
// and what to do next. Caught once, in main; exit code 1.
//
// A broken precondition inside the library is a CHECK, not an InputError. A fit that does not work
// is neither: it is reported in the returned summary (exit code 2).
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& text) : std::runtime_error(text) {}
};

}  // namespace fathom
