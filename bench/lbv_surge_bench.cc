// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Output error against the published parameters on a real log (lbv_surge of FATHOM_REALDATA): free
// runs inside the held-out interval, which output error has not seen and the author has.
//
// The log's author fitted the force shifted by 2.2 s, so his parameters are scored with that shift
// and without it.

#include "fathom/log/log.h"
#include "fathom/log/read_log.h"
#include "fathom/output_error/output_error.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/free_run.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace fathom {
namespace {

// reference.json beside the log: principal component regression and the adaptive law's last values.
constexpr UncoupledModel<double> kAuthorLeastSquares = {12.680732, 0.242507, 3.607200, -0.006061};
constexpr UncoupledModel<double> kAuthorAdaptive = {14.874439, 0.479508, 4.346772, -0.023562};
constexpr double kAuthorShift = 2.2;  // [s]

double HeldOutNmae(const UncoupledModel<double>& model, Log log, double shift) {
  for (double& t : log.command->time) t += shift;
  return FiguresOf({model}, SignalsOf(log, Dof::kSurge).held_out).nmae;
}

int Run(const std::filesystem::path& folder) {
  ReadLogOptions options;
  options.velocity = folder / "author_velocity.csv";
  const Log log = ReadLog(folder, options);
  const OutputErrorSummary summary = FitOutputError(SignalsOf(log, Dof::kSurge).train);
  std::printf("lbv_surge, surge, NMAE of the free run in the held-out interval\n");
  const auto print = [](const char* name, double nmae) { std::printf("%-46s %.3f\n", name, nmae); };
  print("output error, trained outside, no shift", HeldOutNmae(summary.model, log, 0.0));
  print("author's least squares, his shift of 2.2 s",
        HeldOutNmae(kAuthorLeastSquares, log, kAuthorShift));
  print("author's adaptive law, his shift of 2.2 s",
        HeldOutNmae(kAuthorAdaptive, log, kAuthorShift));
  print("author's least squares, no shift", HeldOutNmae(kAuthorLeastSquares, log, 0.0));
  print("author's adaptive law, no shift", HeldOutNmae(kAuthorAdaptive, log, 0.0));
  return summary.IsUsable() ? 0 : 2;
}

}  // namespace
}  // namespace fathom

int main() {
  const char* const given = std::getenv("FATHOM_REALDATA");
  const std::filesystem::path realdata = given != nullptr ? given : FATHOM_REALDATA_DEFAULT;
  const auto folder = realdata / "lbv_surge";
  if (!std::filesystem::exists(folder)) {
    std::printf("skipped: %s is absent; set FATHOM_REALDATA\n", folder.c_str());
    return 0;
  }
  return fathom::Run(folder);
}
