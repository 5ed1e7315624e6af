// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/ulog/ulog_format.h"

#include <optional>
#include <string_view>

namespace fathom {

// The stamps of one topic [s]: its `timestamp`, in microseconds, or milliseconds if it has 8 bits.
// Those of under 64 bits start again at 0 when they are full; these go on.
class UlogClock {
 public:
  // NaN without a `timestamp`. In the order of the file.
  double StampOf(const UlogLayout& layout, std::string_view data);

 private:
  double last_ = 0.0;
  double added_ = 0.0;
};

// When the autopilot started, from its GPS: a log has no other clock that others share.
class UlogGpsTime {
 public:
  // Looks at a message of this topic; the first of vehicle_gps_position or sensor_gps with a fix
  // and a time counts.
  void Take(std::string_view topic, const UlogLayout& layout, std::string_view data);

  // The UTC of stamp 0 [s since 1970]; nothing without a fix.
  std::optional<double> utc_of_zero() const { return utc_of_zero_; }

 private:
  std::optional<double> utc_of_zero_;
};

}  // namespace fathom
