// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/store/tables.h"

#include <string>
#include <vector>

namespace fathom {

// What a later batch takes of a log that is done, so that it need not read again what the programs
// wrote. Tables of Fathom's own, written with the public rows of the log.

struct KnownLogRow {
  std::string log;
  std::string status;   // Name(LogState)
  std::string survey;   // as FormatSurvey() writes it; empty: there is none
  std::string made_by;  // the program that made the log of images or of a recording; empty: none
};

// One DOF for the joint fit of its dive.
struct KnownDofRow {
  std::string log, dof;
  std::string why_left_out;
  double own_nmae = kNoNumber;
};

struct KnownLog {
  KnownLogRow row;
  std::vector<KnownDofRow> dofs;
};

}  // namespace fathom
