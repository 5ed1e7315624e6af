// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/flown_logs.h"

#include "fathom/base/input_error.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/simulate/log_prediction.h"
#include "fathom/tool/print_text.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kMissesAll = 1.0;  // NMAE: the log's own mean predicts it better

}  // namespace

void RequireOtherLogs(const std::vector<Log>& logs,
                      const std::vector<std::string>& log_fingerprints,
                      const std::string& file) {
  for (const Log& log : logs) {
    if (std::ranges::count(log_fingerprints, FingerprintOf(log)) == 0) continue;
    throw InputError(
        fmt::format("--log: {} is a log that {} was fitted to, and counts by the model's "
                    "covariance, expected others.",
                    log.path.string(),
                    file));
  }
  if (logs.empty() || !log_fingerprints.empty()) return;
  PrintText(stderr,
            fmt::format("fathom_plan: {} does not say which logs it was fitted to. If --log names "
                        "one of them, it counts twice.\n",
                        file));
}

void RequireSameVehicle(const Log& log, const FittedModel& model, const std::string& file) {
  const auto prediction = PredictLog(model, log);
  if (prediction && !(prediction->figures.nmae > kMissesAll)) return;
  throw InputError(fmt::format(
      "--log: {} {} {}, expected a model of the same vehicle, and a log that fathom_check finds "
      "nothing wrong with.",
      file,
      prediction ? fmt::format("misses {:.0f} % of the motion in", 100.0 * prediction->figures.nmae)
                 : "diverges over",
      log.path.string()));
}

}  // namespace fathom
