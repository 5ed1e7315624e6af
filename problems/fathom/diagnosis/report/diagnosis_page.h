// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"
#include "fathom/report/page.h"

#include <string>

namespace fathom {

// All of a diagnosis on one page, the sentence and the residuals before and after first.
// `plan_command`: plans the run that decides between its causes; may be empty.
Page DiagnosisPage(const Diagnosis& diagnosis, const std::string& plan_command = "");

// The page where there is none: why, WhyOfNoUse(), and what the checks found.
Page NoDiagnosisPage(const Diagnosis& diagnosis, const std::string& why);

}  // namespace fathom
