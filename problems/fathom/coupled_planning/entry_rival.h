// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/free_entry.h"

namespace fathom {

// A cause that a verdict names, and another that its logs do not tell from it.
struct EntryRival {
  FreeEntry named;     // that the model holds
  double value = 0.0;  // of it there, in its unit; 0 would be without effect
  FreeEntry rival;     // that the model may hold in its place
};

}  // namespace fathom
