// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Output error against what one would write by hand, in one run: time per evaluation of the
// Jacobian and per fit (300 s at 50 Hz), growth from 300 s to 30000 s, and peak memory of each
// length. Exit 1 if a limit is broken. Times are the best of several repetitions.

#include "fathom/output_error/output_error.h"
#include "fathom/output_error/shooting_window.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "best_times.h"
#include "gauss_newton.h"
#include <benchmark/benchmark.h>
#include <ceres/cost_function.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fathom {
namespace {

constexpr UncoupledModel<double> kTruth = {851.05, 60.0, 39.57, -0.81};
constexpr UncoupledModel<double> kGuess = {600.0, 30.0, 60.0, 0.0};
constexpr double kStep = 0.02;  // [s]

double Command(double t) {
  return 40.0 * std::sin(0.06 * t + 0.3) + 40.0 * std::sin(0.17 * t + 2.0) +
         40.0 * std::sin(0.45 * t + 4.1) + 40.0 * std::sin(1.2 * t + 5.0);
}

Segment MakeSegment(double duration) {
  Segment segment;
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 0.01);
  double v = 0.0;
  const int n = static_cast<int>(duration / kStep);
  for (auto* column :
       {&segment.time, &segment.velocity, &segment.command.time, &segment.command.value}) {
    column->reserve(n);
  }
  for (int i = 0; i < n; ++i) {
    const double t = kStep * i, tau = Command(t);
    segment.time.push_back(t);
    segment.velocity.push_back(v + noise(generator));
    segment.command.time.push_back(t);
    segment.command.value.push_back(tau);
    const double middle = v + 0.5 * kStep * kTruth.Acceleration(v, tau);
    v += kStep * kTruth.Acceleration(middle, tau);
  }
  return segment;
}

std::vector<Segment> MakeLog(double duration) {
  std::vector<Segment> segments;
  segments.push_back(MakeSegment(duration));
  return segments;
}

OutputErrorOptions LikeThePeer() {
  OutputErrorOptions options;
  options.initial_guess = kGuess;
  options.huber_k = std::numeric_limits<double>::infinity();
  return options;
}

void FathomJacobian(benchmark::State& state) {
  const Segment segment = MakeSegment(300.0);
  const auto cost = MakeWindowCost({.segment = &segment, .end = segment.time.size()},
                                   std::make_shared<SimulationScratch>());
  std::vector<double> residuals(cost->num_residuals());
  std::vector<double> by_vehicle(3 * residuals.size()), by_buoyancy(residuals.size()),
      by_state(residuals.size());
  double vehicle[] = {std::log(600.0), 30.0, 60.0}, buoyancy[] = {0.0}, initial[] = {0.0};
  const double* blocks[] = {vehicle, buoyancy, initial};
  double* jacobians[] = {by_vehicle.data(), by_buoyancy.data(), by_state.data()};
  for (auto _ : state) {
    initial[0] += 1e-9;  // another point each time, so that nothing is remembered
    benchmark::DoNotOptimize(cost->Evaluate(blocks, residuals.data(), jacobians));
  }
}

void PeerJacobian(benchmark::State& state) {
  const Segment segment = MakeSegment(300.0);
  const GaussNewton peer = {segment.command.value, segment.velocity, kStep};
  Eigen::Matrix<double, 5, 5> JtJ;
  GaussNewton::Parameters Jtr, p = {600.0, 30.0, 60.0, 0.0, 0.0};
  for (auto _ : state) {
    p[4] += 1e-9;
    benchmark::DoNotOptimize(peer.Accumulate(p, &JtJ, &Jtr));
  }
}

void FathomFit(benchmark::State& state) {
  const std::vector<Segment> segments = MakeLog(static_cast<double>(state.range(0)));
  for (auto _ : state) {
    const auto summary = FitOutputError(segments, LikeThePeer());
    if (!summary.IsUsable()) state.SkipWithError(summary.message.c_str());
    state.counters["inertia"] = summary.model.inertia;
    state.counters["iterations"] = summary.num_iterations;
  }
}

void PeerFit(benchmark::State& state) {
  const Segment segment = MakeSegment(static_cast<double>(state.range(0)));
  const GaussNewton peer = {segment.command.value, segment.velocity, kStep};
  for (auto _ : state) {
    int num_iterations = 0;
    const auto p = peer.Fit({600.0, 30.0, 60.0, 0.0, 0.0}, &num_iterations);
    state.counters["inertia"] = p[0];
    state.counters["iterations"] = num_iterations;
  }
}

constexpr int kLengths[] = {300, 3000, 30000};  // [s]
constexpr double kMostOfPeer = 1.6;             // times its CPU time
constexpr double kMostGrowth = 11.5;  // for ten times the data, in the mean of two decades

void Repeat(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->Repetitions(7)->MinTime(0.2);
}
void RepeatAllLengths(benchmark::internal::Benchmark* benchmark) {
  for (const int length : kLengths) benchmark->Arg(length);
  Repeat(benchmark);
}
BENCHMARK(FathomJacobian)->Apply(Repeat);
BENCHMARK(PeerJacobian)->Apply(Repeat);
BENCHMARK(FathomFit)->Apply(RepeatAllLengths);
BENCHMARK(PeerFit)->Apply(RepeatAllLengths);

// Peak memory [MB] of a process that makes a segment and, if asked, fits it.
double PeakMemory(int length, bool with_fit) {
  const pid_t child = fork();
  if (child == 0) {
    const std::vector<Segment> segments = MakeLog(length);
    _exit(!with_fit || FitOutputError(segments, LikeThePeer()).IsUsable() ? 0 : 1);
  }
  int status = 1;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) return std::nan("");
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void PrintMemory() {
  std::printf("Peak memory of a process that holds a log, and of one that fits it\n");
  for (const int length : kLengths) {
    std::printf("%6d s, %8.0f samples   %6.1f MB   %6.1f MB\n",
                length,
                length / kStep,
                PeakMemory(length, false),
                PeakMemory(length, true));
  }
  std::printf("\n");
}

bool PrintRatios(const BestTimes& times) {
  std::printf("\nRatios of the best CPU times\n");
  bool is_kept = times.PrintRatio("FathomJacobian", "PeerJacobian", kMostOfPeer);
  for (const int length : kLengths) {
    const std::string end = "/" + std::to_string(length);
    is_kept = times.PrintRatio("FathomFit" + end, "PeerFit" + end, kMostOfPeer) && is_kept;
  }
  for (const std::string fit : {"FathomFit/", "PeerFit/"}) {
    times.PrintRatio(fit + "3000", fit + "300", kNoLimit);
    times.PrintRatio(fit + "30000", fit + "3000", kNoLimit);
  }
  // A length may by chance take the search one iteration more than another, a sixth of the time;
  // over two decades that evens out.
  std::printf("Growth over both decades\n");
  is_kept =
      times.PrintRatio("FathomFit/30000", "FathomFit/300", kMostGrowth * kMostGrowth) && is_kept;
  return is_kept;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::PrintMemory();  // first, while this process is small: a child's peak begins with it
  fathom::BestTimes times;
  fathom::RunBenchmarks(argc, argv, &times);
  const bool is_kept = fathom::PrintRatios(times);
  if (times.has_failed()) std::fprintf(stderr, "output_error_bench: a fit failed.\n");
  if (!is_kept) std::fprintf(stderr, "output_error_bench: a limit is broken, see above.\n");
  return is_kept && !times.has_failed() ? 0 : 1;
}
