// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/flown_logs.h"

#include "fathom/base/input_error.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/tool/print_text.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

namespace fathom {

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

}  // namespace fathom
