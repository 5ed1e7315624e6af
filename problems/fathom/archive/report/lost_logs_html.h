// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/store/tables.h"

#include <string>
#include <vector>

namespace fathom {

// Every log that gave no model, by state and then by message, the most frequent message first, as
// HTML that needs no script. The paths of many logs with one message are folded away behind it.
std::string LostLogsHtml(const std::vector<LogRow>& logs);

}  // namespace fathom
