// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/stamp_check.h"

#include "fathom/base/quoted.h"
#include "fathom/base/short_number.h"

#include <fmt/format.h>

namespace fathom {

std::vector<Finding> CheckStamps(const Log& log) {
  constexpr double kShareOfAccidents = 0.01;
  std::vector<Finding> findings;
  if (!log.origin) return findings;
  for (const StampsOutOfOrder& stamps : log.origin->out_of_order) {
    if (stamps.share <= kShareOfAccidents) continue;
    findings.push_back({Severity::kWarning,
                        "stamp_order",
                        fmt::format("{} % of the stamps of the {} lay before an earlier one in {}. "
                                    "Are they written wrongly, as nanoseconds without their zeros?",
                                    ShortNumber(100.0 * stamps.share, 2),
                                    stamps.stream,
                                    log.origin->file)});
  }
  if (!log.origin->row_counter.empty()) {
    findings.push_back(
        {Severity::kWarning,
         "row_counter",
         fmt::format(
             "The stamps are column {} of {}, which counts rows: nothing says how long a row "
             "is. Give the map the 'rate' of its streams [Hz].",
             Quoted(log.origin->row_counter),
             log.origin->file)});
  }
  return findings;
}

}  // namespace fathom
