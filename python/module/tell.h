// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/log.h"
#include "fathom/report/page.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// Red findings as Python's warnings (fathom.FindingWarning), once each. Throws where the caller has
// made errors of them.
void WarnOf(const std::vector<Finding>& findings);

// Where a page made in Python comes from.
PageOrigin OriginInPython(const std::vector<Log>& logs);

// A page as a notebook shows it: in a frame of its own, whose styles and scripts touch nothing
// else.
std::string FrameOf(const std::string& page);

// Tables and text for a notebook.
std::string NotebookTable(const Table& table);
std::string NotebookText(const std::string& text);

// "note: ..." lines.
std::string NoteLines(const std::vector<std::string>& notes);

}  // namespace fathom
