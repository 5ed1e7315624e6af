// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/dataflash/gps_time.h"

namespace fathom {
namespace {

constexpr double kGpsEpoch = 315964800.0;  // 1980-01-06 [s since 1970]
constexpr double kWeek = 604800.0;         // [s]
constexpr double kLeapSeconds = 18.0;      // [s], since 2017
constexpr double kFirstWeek = 1900.0;      // of 2016: before, a receiver without almanac
constexpr double kFix = 3.0;               // in three dimensions

}  // namespace

void GpsTime::Take(const MessageFormat& format, std::string_view message) {
  if (utc_of_zero_ || format.name != "GPS") return;
  const MessageField* status = format.FindNumber("Status");
  const MessageField* week = format.FindNumber("GWk");
  const MessageField* millis = format.FindNumber("GMS");
  const MessageField* time = format.FindNumber("TimeUS");
  if (status == nullptr || week == nullptr || millis == nullptr || time == nullptr) return;
  if (ValueOf(*status, message) < kFix || ValueOf(*week, message) < kFirstWeek) return;
  // MULT may state the milliseconds in seconds.
  const double in_week = ValueOf(*millis, message) / millis->multiplier / 1000.0;
  utc_of_zero_ = kGpsEpoch + ValueOf(*week, message) * kWeek + in_week - kLeapSeconds -
                 ValueOf(*time, message);
}

}  // namespace fathom
