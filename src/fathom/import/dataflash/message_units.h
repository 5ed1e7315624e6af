// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/dataflash/message_walk.h"

namespace fathom {

// Gives each field the unit and the multiplier that the log states for it in its messages UNIT,
// MULT and FMTU, and stamps (TimeUS, TimeMS) theirs in any log. Older logs state no other.
void AddUnits(ByteFile* file, MessageFormats* formats);

}  // namespace fathom
