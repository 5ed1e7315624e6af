// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

namespace fathom {

// Whether causes are named that the unseen data do not confirm: their gain may be none.
bool AreUnconfirmed(const Diagnosis& diagnosis);

// Whether causes are named that make the prediction of unseen data worse.
bool AreContradicted(const Diagnosis& diagnosis);

}  // namespace fathom
