// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <string>

namespace fathom {

// Why a candidate was kept or dropped: "dropped: gain 3.0; noise alone reaches 8.1".
std::string WhyText(const Candidate& candidate);

// That no candidate passes, and what became of the best one; empty where one passes or none was
// tried.
std::string NonePassesText(const Diagnosis& diagnosis);

}  // namespace fathom
