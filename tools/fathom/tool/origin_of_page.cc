// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/origin_of_page.h"

#include "fathom/base/number.h"
#include "fathom/base/utc_time.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/version.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

// "0.0 s to 299.9 s" over all streams.
std::string SpanOf(const Log& log) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const std::optional<Stream>* stream :
       {&log.command, &log.velocity, &log.pose, &log.detections}) {
    if (!*stream || (*stream)->time.empty()) continue;
    first = std::min(first, (*stream)->time.front());
    last = std::max(last, (*stream)->time.back());
  }
  return first > last ? "" : fmt::format("{:.1f} s to {:.1f} s", first, last);
}

// Seconds since 1970; those of SOURCE_DATE_EPOCH where it is set, as reproducible-builds.org has
// it: the same run then writes the same bytes.
double Now() {
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) {
    if (const auto seconds = ParseFiniteNumber(fixed)) return *seconds;
  }
  const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
  return std::floor(now.count());
}

}  // namespace

PageOrigin OriginOfPage(const std::vector<Log>& logs) {
  PageOrigin origin = {"Fathom " + VersionWithCommit(), FormatUtc(Now()), CommandLine(), {}};
  for (const Log& log : logs) origin.logs.push_back({log.name, SpanOf(log), FingerprintOf(log)});
  return origin;
}

}  // namespace fathom
