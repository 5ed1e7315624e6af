// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/jobs/run_program.h"
#include "fathom/base/dof.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// A log as a joint fit takes it.
struct DiveLog {
  std::string path;   // from the archive on, as text
  std::string place;  // to open it by, as in FoundLog
  std::string content;
  double own_nmae = std::numeric_limits<double>::quiet_NaN();  // of its own model by output error
};

// All logs of one dive that can identify one DOF.
struct DiveTask {
  std::string vehicle, dive;
  Dof dof = Dof::kSurge;
  std::vector<DiveLog> logs;
  std::string weighting;  // of fathom_identify; empty: its own
};

struct LeftOutLog {
  std::string path;
  std::string why;
};

struct DiveOutcome {
  std::optional<RunRecord> identify;  // its output is the model; none if there was no log
  std::vector<DiveLog> logs;          // in the fit
  std::vector<LeftOutLog> left_out;   // because they spoiled it
};

// One model of all logs of a dive by output error (fathom_identify). A log that spoils it is left
// out:
//
// - one that the program refuses beside the others;
// - one without which alone there is a usable fit;
// - where the joint model simulates half of the logs much worse than their own models do, the one
//   without which it simulates the others best, as long as that is better by a third or more;
// - one that the joint model simulates with an NMAE of more than 0.5, and of more than three times
//   what is usual among the logs of the dive.
DiveOutcome RunDiveJobs(const DiveTask& task, const ProgramSettings& settings, const RunBook& book);

// NMAE of a free run of a model file's text over a log (fathom_simulate); NaN if that did not work.
double PredictionNmae(const std::string& model,
                      const DiveLog& log,
                      const ProgramSettings& settings,
                      const RunBook& book);

}  // namespace fathom
