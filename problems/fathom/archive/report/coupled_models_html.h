// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/report/archive_report.h"

#include <string>

namespace fathom {

// A table of the coupled models, a row for each log: the structure that the data show, the verdict,
// and the numbers that it names; or why there is no usable fit. Empty if there is no such model.
std::string CoupledModelsHtml(const ArchiveReport& report);

}  // namespace fathom
