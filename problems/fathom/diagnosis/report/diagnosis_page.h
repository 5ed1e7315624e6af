// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"
#include "fathom/report/page.h"

namespace fathom {

// All of a diagnosis on one page, the sentence and the residuals before and after first.
Page DiagnosisPage(const Diagnosis& diagnosis);

}  // namespace fathom
