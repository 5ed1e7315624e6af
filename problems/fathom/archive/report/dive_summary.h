// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/report/archive_report.h"

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace fathom {

// What the logs of one dive say of one DOF. A log without a diagnosis is in no verdict: that says
// nothing of its faults.
struct DiveDofSummary {
  bool has_model = false;
  double heldout_nmae = std::numeric_limits<double>::quiet_NaN();  // worst of the logs'
  double prediction_nmae =
      std::numeric_limits<double>::quiet_NaN();  // by the model of an earlier dive
  std::map<std::string, int> causes;             // logs that name it, by effect
  std::map<std::string, int> verdicts;           // logs, by verdict
};

struct DiveSummary {
  std::string dive;               // empty: logs that belong to none
  std::string start;              // of its first log
  std::vector<std::size_t> logs;  // places in Tables::logs
  std::size_t num_without_model = 0;
  int num_red = 0;
  int num_yellow = 0;  // findings
  std::map<std::string, DiveDofSummary> dofs;

  // The worst of its DOFs; NaN: none is known.
  double HeldOutNmae() const;
};

// One for each dive of the report in its order, then dives that only logs name. A log's held-out
// NMAE for a DOF is that of its best model, over families and sources.
std::vector<DiveSummary> SummariesOf(const ArchiveReport& report);

// Places in `summaries`, worst dive first: by logs without a model, then red findings, then
// held-out NMAE; otherwise in their order.
std::vector<std::size_t> WorstFirst(const std::vector<DiveSummary>& summaries);

}  // namespace fathom
