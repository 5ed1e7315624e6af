// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/log_checkup.h"
#include "fathom/report/page_origin.h"

#include <string>

namespace fathom {

// The checkup as a page: the verdict, the next step, the findings with what they do and how to mend
// them, motion and command of each DOF, and how well its parameters are known.
std::string RenderCheckupPage(const LogCheckup& checkup, const PageOrigin& origin);

}  // namespace fathom
