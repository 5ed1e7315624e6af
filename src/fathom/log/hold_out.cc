// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/hold_out.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

// From the first to the last stamp of the motion, or of the command where there is none.
TimeInterval SpanOf(const Log& log) {
  std::optional<TimeInterval> span;
  for (const auto* stream : {&log.velocity, &log.pose, &log.detections}) {
    if (!*stream) continue;
    const TimeInterval own = {.from = (*stream)->time.front(), .to = (*stream)->time.back()};
    span = span ? TimeInterval{std::min(span->from, own.from), std::max(span->to, own.to)} : own;
  }
  if (span) return *span;
  return {.from = StartOf(log), .to = log.command ? log.command->time.back() : StartOf(log)};
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

void RequireHeldOutInside(const std::vector<TimeInterval>& asked, std::span<const Log> logs) {
  for (std::size_t i = 0; i < asked.size(); ++i) {
    std::vector<std::string> spans;
    for (const Log& log : logs) {
      const TimeInterval span = SpanOf(log), held_out = log.held_out[i];
      if (held_out.from <= span.to && span.from <= held_out.to) break;
      const double zero = held_out.from - asked[i].from;
      spans.push_back(fmt::format(
          "{} lasts from {:.1f} to {:.1f} s", log.path.string(), span.from - zero, span.to - zero));
    }
    if (spans.size() < logs.size()) continue;
    throw InputError(
        fmt::format("--held_out: {:g}:{:g} lies outside the data, expected seconds "
                    "within them: {}.",
                    asked[i].from,
                    asked[i].to,
                    fmt::join(spans, ", ")));
  }
}

}  // namespace fathom
