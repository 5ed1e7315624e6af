// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/diagnosis/options.h"
#include "fathom/diagnosis/result.h"
#include "fathom/log/log.h"

#include <span>

namespace fathom {

// Finds what the baseline misses in `logs` along `dof`, names the cause as far as the data force it
// to, and measures what naming it gains. docs/diagnosis.md.
//
// The same input gives the same answer to the last bit. Where no baseline model can be fitted,
// IsUsable() is false. Throws InputError if the logs cannot be used (no command, no motion, too
// short) or have different command units.
Diagnosis Diagnose(std::span<const Log> logs, Dof dof, const DiagnosisOptions& options = {});

}  // namespace fathom
