// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/correct_velocity.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// The column of a correction; throws if it is not there. `says`: what asks for it, "--correct".
std::vector<double>& ColumnOf(const Correction& correction,
                              const std::string& says,
                              const std::string& velocity,
                              Stream* stream) {
  const auto column = std::ranges::find(stream->columns, correction.column);
  if (column == stream->columns.end()) {
    throw InputError(fmt::format("{}: corrects {}, which is no column of {}, expected one of: {}.",
                                 says,
                                 Quoted(correction.column),
                                 velocity,
                                 fmt::join(stream->columns, ", ")));
  }
  return stream->values[std::distance(stream->columns.begin(), column)];
}

// Of values at `time`: what they are at `t`, which lies between two of these times.
double Between(const std::vector<double>& time, const std::vector<double>& values, double t) {
  const auto after = std::ranges::lower_bound(time, t);
  const auto i = after - time.begin();
  if (*after == t) return values[i];
  return std::lerp(values[i - 1], values[i], (t - time[i - 1]) / (*after - time[i - 1]));
}

// Leaves only the rows from one time on to another.
void KeepBetween(double from, double to, Stream* stream) {
  const auto first = std::ranges::lower_bound(stream->time, from) - stream->time.begin();
  const auto last = std::ranges::upper_bound(stream->time, to) - stream->time.begin();
  const auto keep = [&](std::vector<double>* values) {
    values->erase(values->begin() + std::max(first, last), values->end());
    values->erase(values->begin(), values->begin() + first);
  };
  for (std::vector<double>& values : stream->values) keep(&values);
  keep(&stream->time);
}

std::string Said(const Correction& correction) {
  std::vector<std::string> parts;
  if (correction.factor != 1.0 || correction.late == 0.0)
    parts.push_back(fmt::format("times {}", correction.factor));
  if (correction.late != 0.0) {
    const char* where = correction.late > 0.0 ? "earlier" : "later";
    parts.push_back(fmt::format("{} s {}", std::abs(correction.late), where));
  }
  return fmt::format("{} {}", correction.column, fmt::join(parts, " and "));
}

// `says`: what asks for it, "--correct".
void PutRight(const std::vector<Correction>& corrections,
              const std::string& says,
              const std::string& velocity,
              Log* log) {
  if (corrections.empty()) return;
  if (!log->velocity) {
    throw InputError(
        fmt::format("{}: corrects columns of velocity.csv, but {} holds none. Leave it out.",
                    says,
                    log->path.string()));
  }
  Stream& stream = *log->velocity;
  const std::vector<double> time = stream.time;
  double latest = 0.0, earliest = 0.0;
  std::vector<std::string> done;
  for (const Correction& correction : corrections) {
    std::vector<double>& values = ColumnOf(correction, says, velocity, &stream);
    const std::vector<double> before = values;
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double t = std::clamp(time[i] + correction.late, time.front(), time.back());
      values[i] = correction.factor * Between(time, before, t);
    }
    latest = std::max(latest, correction.late);
    earliest = std::min(earliest, correction.late);
    done.push_back(Said(correction));
  }
  if (!time.empty()) KeepBetween(time.front() - earliest, time.back() - latest, &stream);
  if (stream.time.empty() && !time.empty()) {
    throw InputError(fmt::format("{}: {} is shorter than its columns are late.", says, velocity));
  }
  log->remarks.push_back({RemarkKind::kGeneral,
                          fmt::format("{}: {}, as {} says.",
                                      std::filesystem::path(velocity).filename().string(),
                                      fmt::join(done, ", "),
                                      std::filesystem::path(says).filename().string())});
}

}  // namespace

void CorrectVelocity(const std::string& log_yaml,
                     const std::string& velocity,
                     const std::vector<Correction>& asked,
                     const std::string& asked_by,
                     Log* log) {
  std::erase_if(log->corrections, [&](const Correction& of_log) {
    return std::ranges::find(asked, of_log.column, &Correction::column) != asked.end();
  });
  PutRight(log->corrections, log_yaml, velocity, log);
  PutRight(asked, asked_by, velocity, log);
  std::ranges::copy(asked, std::back_inserter(log->corrections));
}

}  // namespace fathom
