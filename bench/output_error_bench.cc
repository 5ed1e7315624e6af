// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Output error against what one would write by hand, in one run: time per evaluation of the
// Jacobian and per fit (300 s at 50 Hz), growth from 300 s to 30000 s, and peak memory.

#include "fathom/output_error/output_error.h"
#include "fathom/output_error/shooting_window.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "gauss_newton.h"
#include <benchmark/benchmark.h>
#include <ceres/cost_function.h>
#include <sys/resource.h>

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
  std::vector<double> by_parameters(4 * residuals.size()), by_state(residuals.size());
  double parameters[] = {std::log(600.0), 30.0, 60.0, 0.0}, initial[] = {0.0};
  const double* blocks[] = {parameters, initial};
  double* jacobians[] = {by_parameters.data(), by_state.data()};
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
  const std::vector<Segment> segments = {MakeSegment(static_cast<double>(state.range(0)))};
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

BENCHMARK(FathomJacobian)->Unit(benchmark::kMillisecond);
BENCHMARK(PeerJacobian)->Unit(benchmark::kMillisecond);
BENCHMARK(FathomFit)->Arg(300)->Arg(3000)->Arg(30000)->Unit(benchmark::kMillisecond);
BENCHMARK(PeerFit)->Arg(300)->Arg(3000)->Arg(30000)->Unit(benchmark::kMillisecond);

// Keeps the CPU times, for the ratios at the end.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const bool is_median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
      if (is_median || run.repetitions <= 1) time_[run.run_name.str()] = run.GetAdjustedCPUTime();
    }
  }

  void PrintRatios() const {
    const auto ratio = [&](const char* above, const char* below) {
      if (!time_.count(above) || !time_.count(below)) return;
      std::printf("%-34s %5.2f\n",
                  (std::string(above) + " / " + below).c_str(),
                  time_.at(above) / time_.at(below));
    };
    std::printf("\nRatios of CPU time (limits: 3 against the peer, 10 for ten times the data)\n");
    ratio("FathomJacobian", "PeerJacobian");
    ratio("FathomFit/300", "PeerFit/300");
    ratio("FathomFit/3000", "FathomFit/300");
    ratio("FathomFit/30000", "FathomFit/3000");
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("peak memory %.0f MB\n", static_cast<double>(usage.ru_maxrss) / 1024.0);
  }

 private:
  std::map<std::string, double> time_;
};

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  fathom::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.PrintRatios();
}
