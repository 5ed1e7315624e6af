// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/log_checkup.h"

#include <string>

namespace fathom {

// As JSON, schema "fathom-check-1"; docs/check.md.
std::string FormatCheckupJson(const LogCheckup& checkup);

}  // namespace fathom
