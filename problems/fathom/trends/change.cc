// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/change.h"

namespace fathom {

std::string_view Name(ChangeKind kind) { return kind == ChangeKind::kStep ? "step" : "trend"; }

}  // namespace fathom
