// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/input_error.h"

#include <functional>
#include <string>

namespace fathom {

// The text of the InputError that an action throws; "no error" if it throws none.
inline std::string ErrorFrom(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace fathom
