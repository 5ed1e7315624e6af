// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/correct_velocity.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// `says`: what asks for it, "--correct".
void Multiply(const std::vector<Correction>& corrections,
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
  std::vector<std::string> done;
  for (const Correction& correction : corrections) {
    const auto column = std::ranges::find(stream.columns, correction.column);
    if (column == stream.columns.end()) {
      throw InputError(
          fmt::format("{}: corrects {}, which is no column of {}, expected one of: {}.",
                      says,
                      Quoted(correction.column),
                      velocity,
                      fmt::join(stream.columns, ", ")));
    }
    for (double& value : stream.values[std::distance(stream.columns.begin(), column)]) {
      value *= correction.factor;
    }
    done.push_back(fmt::format("{} times {}", correction.column, correction.factor));
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
                     Log* log) {
  std::erase_if(log->corrections, [&](const Correction& of_log) {
    return std::ranges::find(asked, of_log.column, &Correction::column) != asked.end();
  });
  Multiply(log->corrections, log_yaml, velocity, log);
  Multiply(asked, "--correct", velocity, log);
  std::ranges::copy(asked, std::back_inserter(log->corrections));
}

}  // namespace fathom
