// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/jobs/run_program.h"
#include "fathom/base/dof.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// A log as a joint fit takes it.
struct DiveLog {
  std::string path;             // from the archive on, as text
  std::filesystem::path place;  // to open it by
  std::string content;
};

// All logs of one dive that can identify one DOF.
struct DiveTask {
  std::string vehicle, dive;
  Dof dof = Dof::kSurge;
  std::vector<DiveLog> logs;
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
// out: one that the program refuses beside the others; one without which alone there is a usable
// fit; one whose free run with the joint model errs more than three times as much as is usual among
// the logs of the dive, and by an NMAE of more than 0.5.
DiveOutcome RunDiveJobs(const DiveTask& task, const ProgramSettings& settings, const RunBook& book);

// NMAE of a free run of a model file's text over a log (fathom_simulate); NaN if that did not work.
double PredictionNmae(const std::string& model,
                      const DiveLog& log,
                      const ProgramSettings& settings,
                      const RunBook& book);

}  // namespace fathom
