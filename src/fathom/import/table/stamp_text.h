// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>

namespace fathom {

// A stamp that is written as a date or a time of day.
struct TextStamp {
  bool has_date = false;
  double seconds = 0.0;  // since 1970 in UTC with a date, since midnight without
};

// "2026-05-03T14:30:05.25Z", "2026-05-03 14:30:05", "2026/05/03 14:30", "03.05.2026 14:30:05,2"
// (day first), "2026-05-03", "14:30:05.2", and "03.05.2026". Nothing for anything else; a date as
// 03/05/2026 may be of May or of March.
std::optional<TextStamp> ParseTextStamp(std::string_view text);

}  // namespace fathom
