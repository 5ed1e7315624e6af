// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/ordinary_dives/ordinary_dives.h"

#include <string>

namespace fathom {

// JSON, schema "fathom-ordinary-1": docs/file_formats.md.
std::string FormatOrdinaryDives(const OrdinaryRequest& request, const OrdinaryDives& dives);

}  // namespace fathom
