// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace fathom {

// What a diagnosis ends with.
enum class Verdict {
  kConsistent,   // nothing beyond noise, and nothing red is said of the data
  kExplained,    // one or more causes are named
  kAmbiguous,    // something is missing, and these logs cannot tell which of several causes it is
  kUnexplained,  // something is missing, and nothing that is known accounts for it
};

// "consistent", "explained", "ambiguous" or "unexplained".
std::string_view Name(Verdict verdict);

}  // namespace fathom
