// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/report/archive_report.h"

#include <string>

namespace fathom {

// The page of an archive: one HTML file that loads nothing. What changed and what became of the
// logs stand in it as sentences, for readers without a script; charts, the table of dives and the
// comparison of two dives are drawn by its scripts. All texts are plain text and are escaped.
// docs/report.md tells how to read it.
std::string RenderArchivePage(const ArchiveReport& report);

}  // namespace fathom
