// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/dataflash/message_format.h"

#include <optional>
#include <string_view>

namespace fathom {

// When the autopilot started, from its GPS: a log has no other clock that others share.
class GpsTime {
 public:
  // Looks at a message; the first GPS message with a fix counts.
  void Take(const MessageFormat& format, std::string_view message);

  // The UTC of stamp 0 [s since 1970], to a second or so: GPS time is 18 s ahead of UTC since 2017,
  // and the fix was some tenths old. Nothing without a fix.
  std::optional<double> utc_of_zero() const { return utc_of_zero_; }

 private:
  std::optional<double> utc_of_zero_;
};

}  // namespace fathom
