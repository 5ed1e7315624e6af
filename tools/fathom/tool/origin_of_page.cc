// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/origin_of_page.h"

#include "fathom/base/utc_time.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/tool/tool.h"

#include <algorithm>
#include <chrono>
#include <cmath>
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

}  // namespace

PageOrigin OriginOfPage(const std::vector<Log>& logs) {
  const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
  PageOrigin origin = {VersionOfTools(), FormatUtc(std::floor(now.count())), CommandLine(), {}};
  for (const Log& log : logs) origin.logs.push_back({log.name, SpanOf(log), FingerprintOf(log)});
  return origin;
}

}  // namespace fathom
