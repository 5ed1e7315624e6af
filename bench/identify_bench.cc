// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_identify as a whole process, from the files to the last line, on logs at 50 Hz with equal
// steps and with jittered ones: CPU time over that of a hand-written Gauss-Newton fit of 300 s in
// the same run, and peak memory. Exit 1 if a limit is broken. Times are the best of several runs.
//
//   build/release/bench/identify_bench

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "gauss_newton.h"
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fathom {
namespace {

constexpr double kStep = 0.02;  // [s]

struct Run {
  std::vector<double> time, force, velocity;
};

Run MakeRun(double duration, double jitter) {
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 0.01);
  std::uniform_real_distribution<double> early_or_late(-jitter * kStep, jitter * kStep);
  Run run;
  double v = 0.0;
  for (int i = 0; i * kStep < duration; ++i) {
    const double t = i == 0 ? 0.0 : i * kStep + early_or_late(generator);
    if (i > 0) {
      const double h = t - run.time.back(), tau = run.force.back();
      const auto slope = [tau](double speed) {
        return (tau - (60.0 * std::abs(speed) + 39.57) * speed + 0.81) / 851.05;
      };
      v += h * slope(v + 0.5 * h * slope(v));
    }
    run.time.push_back(t);
    run.force.push_back(40.0 * (std::sin(0.06 * t + 0.3) + std::sin(0.17 * t + 2.0) +
                                std::sin(0.45 * t + 4.1) + std::sin(1.2 * t + 5.0)));
    run.velocity.push_back(v + noise(generator));
  }
  return run;
}

void WriteLog(const Run& run, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "log.yaml") << "name: bench\ndof: surge\n";
  std::ofstream command(folder / "command.csv"), velocity(folder / "velocity.csv");
  command << "t,tau_surge\n";
  velocity << "t,u\n";
  for (size_t i = 0; i < run.time.size(); ++i) {
    command << fmt::format("{:.6f},{:.4f}\n", run.time[i], run.force[i]);
    velocity << fmt::format("{:.6f},{:.5f}\n", run.time[i], run.velocity[i]);
  }
}

struct Cost {
  double seconds = std::numeric_limits<double>::infinity();  // of CPU
  double megabytes = 0.0;                                    // at the peak
};

// The best of `num_runs`; NaN if the tool fails.
Cost CostOfTool(const std::filesystem::path& log, int num_runs) {
  const std::string flag = "--log=" + log.string();
  Cost best;
  for (int i = 0; i < num_runs; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
      execl(FATHOM_IDENTIFY, FATHOM_IDENTIFY, flag.c_str(), nullptr);
      _exit(127);
    }
    int status = 1;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) {
      return {std::nan(""), std::nan("")};
    }
    const auto seconds = [](const timeval& t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    best.seconds = std::min(best.seconds, seconds(usage.ru_utime) + seconds(usage.ru_stime));
    best.megabytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
  }
  return best;
}

// CPU time [s] of the peer's fit of 300 s, the best of several.
double PeerSeconds() {
  const Run run = MakeRun(300.0, 0.0);
  const GaussNewton peer = {run.force, run.velocity, kStep};
  double best = std::numeric_limits<double>::infinity(), sum = 0.0;
  for (int i = 0; i < 50; ++i) {
    const std::clock_t begin = std::clock();
    int num_iterations = 0;
    sum += peer.Fit({600.0, 30.0, 60.0, 0.0, 0.0}, &num_iterations)[0];
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return sum > 0.0 ? best : std::nan("");
}

// Prints a figure. False if it is above `limit`, or not a number.
bool Print(const std::string& what, double figure, double limit) {
  const bool is_kept = figure <= limit;
  std::printf("  %-34s %8.1f  %s %g\n",
              what.c_str(),
              figure,
              is_kept ? "at most" : "BROKEN: at most",
              limit);
  return is_kept;
}

struct Case {
  double duration;  // [s]
  int num_runs;
  double most_of_peer;  // times its CPU time
  double most_megabytes;
};

constexpr Case kCases[] = {{300.0, 15, 12.0, 30.0}, {30000.0, 3, 600.0, 250.0}};

bool RunAll() {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("identify_bench_{}", getpid());
  const double peer = PeerSeconds();
  std::printf("hand-written fit of 300 s: %.2f ms\n", 1e3 * peer);
  bool is_kept = true;
  for (const auto& [duration, num_runs, most_of_peer, most_megabytes] : kCases) {
    for (const double jitter : {0.0, 0.2}) {
      WriteLog(MakeRun(duration, jitter), folder);
      const Cost cost = CostOfTool(folder, num_runs);
      std::printf("%.0f s, %s steps: %.1f ms\n",
                  duration,
                  jitter > 0.0 ? "jittered" : "equal",
                  1e3 * cost.seconds);
      is_kept = Print("CPU time over the peer's", cost.seconds / peer, most_of_peer) && is_kept;
      is_kept = Print("peak memory [MB]", cost.megabytes, most_megabytes) && is_kept;
    }
  }
  std::filesystem::remove_all(folder);
  return is_kept;
}

}  // namespace
}  // namespace fathom

int main() {
  const bool is_kept = fathom::RunAll();
  if (!is_kept) std::fprintf(stderr, "identify_bench: a limit is broken, see above.\n");
  return is_kept ? 0 : 1;
}
