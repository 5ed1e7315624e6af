// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/hold_out.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kEpoch = 1e6;  // stamps beyond this count from some epoch [s]

// The first stamp of the motion, or of the command where there is none.
double StartOf(const Log& log) {
  for (const auto* stream : {&log.velocity, &log.pose, &log.detections, &log.command}) {
    if (*stream) return (*stream)->time.front();
  }
  return 0.0;
}

TimeInterval InLogTime(const TimeInterval& asked, double start) {
  if (start < kEpoch || asked.to >= kEpoch) return asked;
  return {.from = start + asked.from, .to = start + asked.to};
}

bool HoldsASample(const TimeInterval& interval, const std::optional<Stream>& stream) {
  return stream && std::any_of(stream->time.begin(), stream->time.end(), [&](double t) {
           return interval.Contains(t);
         });
}

}  // namespace

void HoldOut(const std::vector<TimeInterval>& asked, Log* log) {
  if (!asked.empty()) {
    log->held_out.clear();
    for (const TimeInterval& one : asked) log->held_out.push_back(InLogTime(one, StartOf(*log)));
  }
  for (const TimeInterval& interval : log->held_out) {
    if (HoldsASample(interval, log->velocity) || HoldsASample(interval, log->pose) ||
        HoldsASample(interval, log->detections)) {
      continue;
    }
    log->remarks.push_back({RemarkKind::kGeneral,
                            fmt::format("{} [{}, {}] holds no sample of the motion.",
                                        asked.empty() ? "log.yaml: held_out" : "--held_out:",
                                        interval.from,
                                        interval.to)});
  }
}

}  // namespace fathom
