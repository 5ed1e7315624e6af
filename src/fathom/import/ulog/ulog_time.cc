// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ulog/ulog_time.h"

#include <cmath>

namespace fathom {
namespace {

constexpr double kMicro = 1e-6;       // [s]
constexpr double kYear2016 = 1.45e9;  // [s since 1970]: before, a receiver without almanac
constexpr double kULogFix = 3.0;      // in three dimensions

}  // namespace

double UlogClock::StampOf(const UlogLayout& layout, std::string_view data) {
  const PackedNumber* field = layout.Find("timestamp");
  if (field == nullptr) return NAN;
  const double number = ValueOf(*field, data);
  if (field->type == NumberType::kUint64) return number * kMicro;
  if (number < last_) added_ += std::ldexp(1.0, static_cast<int>(8 * SizeOf(field->type)));
  if (!std::isnan(number)) last_ = number;
  return (added_ + number) * (field->type == NumberType::kUint8 ? 1e-3 : kMicro);
}

void UlogGpsTime::Take(std::string_view topic, const UlogLayout& layout, std::string_view data) {
  if (utc_of_zero_ || (topic != "vehicle_gps_position" && topic != "sensor_gps")) return;
  const PackedNumber* fix = layout.Find("fix_type");
  const PackedNumber* utc = layout.Find("time_utc_usec");
  const PackedNumber* time = layout.Find("timestamp");
  if (fix == nullptr || utc == nullptr || time == nullptr) return;
  const double seconds = ValueOf(*utc, data) * kMicro;
  if (!(ValueOf(*fix, data) >= kULogFix) || !(seconds > kYear2016)) return;
  // The stamp is of the position; the time of the UTC is given relative to it.
  const PackedNumber* relative = layout.Find("timestamp_time_relative");
  const double delay = relative == nullptr ? 0.0 : ValueOf(*relative, data) * kMicro;
  const double utc_of_zero = seconds - ValueOf(*time, data) * kMicro - delay;
  if (std::isfinite(utc_of_zero)) utc_of_zero_ = utc_of_zero;
}

}  // namespace fathom
