// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// FitJoint() over one marker at 10 Hz, 600 to 60000 frames: seconds in all, per iteration, and per
// iteration of the same bundle adjustment without the model, all in one run; peak memory. The
// figures of docs/joint_refinement.md.
//
//   joint_bench [most frames=60000]

#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/joint_refinement/problem/joint_problem.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "camera_experiment.h"
#include "truth.h"
#include <fmt/format.h>
#include <sys/resource.h>

namespace fathom {
namespace {

double PeakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double ProcessorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Of the same corners with a pose of its own for every frame, and no model.
double PlainSecondsPerIteration(const SyntheticCameraRun& run) {
  Truth truth = TruthOf(run);
  // From off the solution, so that there is something to iterate for.
  for (auto& deviation : truth.unknowns.segments[0].deviation) {
    PoseVector::Map(deviation.data()) += PoseVector(0.03, -0.02, 0.02, 0.01, -0.01, 0.02);
  }
  ProcessSet processes;
  processes.corner_sigma = 0.3;
  GlobalsPrior prior;  // clock, size and mount are known
  for (int i = kSizeColumn; i < kNumShared; ++i) prior.std[i] = 0.0;
  prior.std[kClockColumn] = 0.0;
  const BoundedSolve solve =
      SolveJoint(&truth.data, processes, {prior}, {.without_model = true}, &truth.unknowns);
  return solve.seconds_per_iteration;
}

void Measure(Dof dof, int num_frames) {
  const SyntheticCameraRun run = Synthesize(
      {.dof = dof, .input = InputKind::kMultisine, .duration = 0.1 * num_frames, .seed = 1});
  static const double before = PeakMegabytes();  // of the first fit
  const auto wall = std::chrono::steady_clock::now();
  const double processor = ProcessorSeconds();
  const JointSummary summary = FitJoint(run.input);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  const double processor_seconds = ProcessorSeconds() - processor;
  const double megabytes = PeakMegabytes() - before;
  fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.3f} | {} | {} | {:.4f} | {:.4f} | {:.0f} | {} |\n",
             Name(dof),
             run.input.segments[0].time.size(),
             seconds,
             processor_seconds,
             1e3 * processor_seconds / static_cast<double>(run.input.segments[0].time.size()),
             summary.num_rounds,
             summary.num_iterations,
             summary.seconds_per_iteration,
             PlainSecondsPerIteration(run),
             megabytes,
             summary.IsUsable() ? "usable" : summary.message);
  std::fflush(stdout);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  using namespace fathom;
  const int most = argc > 1 ? std::atoi(argv[1]) : 60000;
  fmt::print(
      "| run | frames | s | CPU s | CPU ms per frame | rounds | iterations | s per iteration | "
      "without the model | MB | |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const int frames : {600, 2000, 6000, 20000, 60000}) {
    if (frames > most) continue;
    for (const Dof dof : {Dof::kSurge, Dof::kHeave}) Measure(dof, frames);
  }
  return 0;
}
