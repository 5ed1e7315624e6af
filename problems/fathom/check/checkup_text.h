// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/log_checkup.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// What the colours of findings mean.
inline constexpr const char* kColourKey =
    "Red: no model of this log should be believed before this is explained. Yellow: worth knowing. "
    "Green: nothing was found.";

Table StreamTable(const LogCheckup& checkup);

// How well this log knows each parameter of a DOF, by output error: with an unknown delay of the
// command, where the data do not tell one.
Table DeterminedTable(const LogCheckup& checkup, const DofCheckup& dof);

// "; in doubt: ..." to follow the key of that table; empty where nothing is.
std::string WordsOnDoubt(const LogCheckup& checkup, const DofCheckup& dof);

// What fathom_identify says of this model beyond its intervals, a sentence each; may be empty.
std::vector<std::string> CaveatsOn(const DofCheckup& dof);

// Where the log is excited, and what to hold out, a sentence each; may be empty.
std::vector<std::string> ExcitationSentences(const LogCheckup& checkup, const DofCheckup& dof);

// All of it for a terminal.
std::string FormatCheckup(const LogCheckup& checkup);

}  // namespace fathom
