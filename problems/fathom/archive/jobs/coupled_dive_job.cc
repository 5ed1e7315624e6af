// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/coupled_dive_job.h"

#include "fathom/base/exit_code.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/input_error.h"
#include "fathom/vehicle/files/coupled_model_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {

RunRecord RunCoupledDiveJob(const CoupledDiveTask& task,
                            const ProgramSettings& settings,
                            const RunBook& book) {
  ProgramCall call = {
      .program = "fathom_identify",
      .flags = {"--dofs=" + task.dofs,
                std::string("--structure=") + (task.coriolis ? "coriolis" : "diagonal")},
      .output = "model"};
  if (!task.free.empty()) {
    call.flags.push_back(fmt::format("--free={}", fmt::join(task.free, ",")));
  }
  for (const DiveLog& log : task.logs) {
    call.contents.push_back(log.content);
    call.places.push_back("--log=" + log.place);
  }
  RunRecord run = RunProgram(call, settings, book);
  if (!IsUsable(run)) return run;
  try {
    ParseCoupledModel("what it wrote", run.output);
  } catch (const InputError& error) {  // one damaged file must not end the batch
    run.exit_code = kExitNoFit;
    run.message = CleanText(error.what());
  }
  return run;
}

}  // namespace fathom
