// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/free_entry.h"

#include <string>
#include <string_view>

namespace fathom {

// As FreeEntry's own comment lists them.
std::string NameOf(const FreeEntry& entry);

// Throws InputError, with what was found and expected, for what names no entry: "'inertia.up' is no
// entry of a coupled model: ...". A thruster or a fin may have any name.
FreeEntry ParseFreeEntry(std::string_view name);

// "kg m^2/s"; "1" of a thrust gain, "rad" of a fin's angles, "rad/s" of its rate, "s" of a lag. Of
// commands in another unit than N and N m, "kg A/N".
std::string UnitOf(const FreeEntry& entry, const std::string& force_unit = "N");

}  // namespace fathom
