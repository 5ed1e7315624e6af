// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/judge/judgement.h"
#include "fathom/diagnosis/result.h"

#include <cstdint>
#include <vector>

namespace fathom {

// Adds what is told of a judgement to `diagnosis`, which holds what is told of its data.
Diagnosis Described(const MeasuredSegments& segments,
                    const Prepared& prepared,
                    const Judgement& judgement,
                    Diagnosis diagnosis);

}  // namespace fathom
