// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_batch costs beside the programs that it runs, on an example archive of 4 dives of
// 9 logs: its CPU time, with that of its children, over that of a shell that runs the same command
// lines one after the other; its duration with one program at a time over that with two, beside the
// same of xargs, which waits for nothing; a rerun that finds nothing new among 1000 logs; one that
// finds one new log beside 3000; its own peak memory at 100 and at 1000 logs. In the last three the
// programs are stubs. Exit 1 if a limit is broken. Times are the best of several runs.
//
//   build/release/bench/batch_bench

#include "fathom/log/log_content.h"
#include "fathom/process/run_child.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

constexpr double kMostCpuRatio = 1.05;
constexpr double kLeastSpeedUp = 1.8;   // on two cores that nobody else uses
constexpr double kLongestRerun = 1.0;   // [s]
constexpr double kLongestNewLog = 2.0;  // beside 3000 [s]
constexpr double kMostGrowth = 10.0;    // of the parent from 100 to 1000 logs [MB]

const fs::path kTools = FATHOM_TOOLS;

void Write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

ChildResult Run(const ChildCommand& command) {
  ChildResult result = RunChild(command);
  if (result.exit_code != 0) {
    fmt::print(stderr, "{}: {}\n", command.program, result.err);
    std::exit(2);
  }
  return result;
}

ChildCommand Batch(const fs::path& archive, const fs::path& results, int jobs) {
  return {.program = (kTools / "fathom_batch").string(),
          .arguments = {"--archive=" + archive.string(),
                        "--results=" + results.string(),
                        fmt::format("--jobs={}", jobs)}};
}

ChildResult FreshBatch(const fs::path& archive, const fs::path& results, int jobs) {
  fs::remove(results);
  return Run(Batch(archive, results, jobs));
}

// The same programs with the same flags, a command line each. What they write is not kept.
fs::path FileOfRuns(const fs::path& results, const fs::path& folder) {
  SQLite::Database database(results.string(), SQLite::OPEN_READWRITE);
  SQLite::Statement select(database, "SELECT program, arguments, output FROM runs");
  std::string lines;
  while (select.executeStep()) {
    const std::string program = select.getColumn(0).getString();
    std::string line = (kTools / program).string() + " " + select.getColumn(1).getString();
    const std::string out = (folder / "out.json").string();
    if (program == "fathom_identify") {
      line += " --model=" + out;
      // The batch gave this model to fathom_simulate in a file of its own, which is gone.
      const std::string model = select.getColumn(2).getString();
      Write(results.string() + ".work/" + DigestOf(model) + ".model.json", model);
    } else if (program == "fathom_diagnose") {
      line += " --verdict=" + out;
    } else if (program != "fathom_batch") {
      line += " --json=" + out;
    }
    lines += line + " > /dev/null 2> /dev/null\n";
  }
  Write(folder / "runs.sh", lines);
  return folder / "runs.sh";
}

// The command lines, two at a time.
ChildCommand TwoAtATime(const fs::path& runs) {
  return {.program = "xargs",
          .arguments = {"-a", runs, "-d", "\n", "-P", "2", "-I", "LINE", "sh", "-c", "LINE"}};
}

// One minute of a square wave of force, and of the speed that it gives a vehicle; `number` is in
// the last digits of one row.
void WriteLog(const fs::path& folder, int number) {
  std::string command = "t,tau_surge\n", velocity = "t,u\n";
  double v = 0.0;
  for (int row = 0; row <= 600; ++row) {
    const double force = row / 40 % 2 == 0 ? 20.0 : -20.0;
    command += fmt::format("{:.1f},{}\n", 0.1 * row, force);
    velocity += fmt::format("{:.1f},{:.6f}\n", 0.1 * row, row == 300 ? v + 1e-6 * number : v);
    v += 0.1 * (force - 30.0 * v * std::abs(v) - 5.0 * v) / 40.0;
  }
  Write(folder / "log.yaml", "name: bench\ndof: surge\n");
  Write(folder / "command.csv", command);
  Write(folder / "velocity.csv", velocity);
}

fs::path WriteArchive(const fs::path& archive, int num_logs) {
  for (int i = 0; i < num_logs; ++i) {
    WriteLog(archive / fmt::format("dive_{}/run_{}", i / 10, i % 10), i + 1);
  }
  return archive;
}

// The most memory that a process itself has held, as it told while it ran [MB].
class PeakOf {
 public:
  explicit PeakOf(int pid) : thread_([this, pid] { Watch(pid); }) {}
  ~PeakOf() { thread_.join(); }
  static double Last() { return last_; }

 private:
  void Watch(int pid) {
    while (true) {
      std::ifstream status(fmt::format("/proc/{}/status", pid));
      double peak = 0.0;
      for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) peak = std::strtod(line.c_str() + 6, nullptr) / 1024.0;
      }
      if (peak == 0.0) return;  // it has ended
      last_ = peak;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  static inline std::atomic<double> last_ = 0.0;
  std::thread thread_;
};

bool Report(const std::string& what,
            double value,
            const std::string& unit,
            bool holds,
            const std::string& limit) {
  fmt::print("{:<58} {:>8.3f} {:<3} {:<16} {}\n", what, value, unit, limit, holds ? "" : "BROKEN");
  std::fflush(stdout);
  return holds;
}

bool MeasureRealPrograms(const fs::path& folder) {
  const fs::path archive = folder / "example", results = folder / "example.sqlite";
  setenv("PATH", fmt::format("{}/tools:{}", FATHOM_BUILD_DIR, std::getenv("PATH")).c_str(), 1);
  Run({.program = FATHOM_SOURCE_DIR "/data/examples/example_archive.sh",
       .arguments = {archive.string(), "4", "9"}});
  constexpr double kNever = std::numeric_limits<double>::infinity();
  double batch_cpu = kNever, shell_cpu = kNever, alone = kNever, in_two = kNever;
  double shell_alone = kNever, shell_in_two = kNever;
  for (int i = 0; i < 3; ++i) {
    const ChildResult one = FreshBatch(archive, results, 1);
    batch_cpu = std::min(batch_cpu, one.cpu_seconds);
    alone = std::min(alone, one.seconds);
    const fs::path runs = FileOfRuns(results, folder);
    const ChildResult shell = Run({.program = "sh", .arguments = {"-e", runs}});
    shell_cpu = std::min(shell_cpu, shell.cpu_seconds);
    shell_alone = std::min(shell_alone, shell.seconds);
    shell_in_two = std::min(shell_in_two, Run(TwoAtATime(runs)).seconds);
    in_two = std::min(in_two, FreshBatch(archive, results, 2).seconds);
  }
  fmt::print("36 logs, CPU: batch {:.2f} s, shell {:.2f} s\n", batch_cpu, shell_cpu);
  fmt::print("36 logs, duration: --jobs=1 {:.2f} s, --jobs=2 {:.2f} s\n", alone, in_two);
  const double ratio = batch_cpu / shell_cpu, speed_up = alone / in_two;
  bool holds = Report("CPU time over that of a shell loop",
                      ratio,
                      "",
                      ratio <= kMostCpuRatio,
                      fmt::format("at most {}", kMostCpuRatio));
  holds &= Report("Duration with --jobs=1 over that with --jobs=2",
                  speed_up,
                  "",
                  speed_up >= kLeastSpeedUp,
                  fmt::format("at least {}", kLeastSpeedUp));
  Report("  the same of the shell and xargs -P 2", shell_alone / shell_in_two, "", true, "");
  return holds;
}

void MakeStubs(const fs::path& stubs) {
  fs::create_directories(stubs);
  for (const char* verb : {"batch", "compare", "diagnose", "identify", "simulate", "track"}) {
    fs::create_symlink(FATHOM_STUB_TOOL, stubs / (std::string("fathom_") + verb));
  }
}

bool MeasureOneNewLog(const fs::path& folder) {
  constexpr int kNumLogs = 3000;
  const fs::path archive = WriteArchive(folder / "growing", kNumLogs);
  ChildCommand batch = Batch(archive, folder / "growing.sqlite", 2);
  batch.arguments.push_back("--tools=" + (folder / "stubs").string());
  Run(batch);
  double least = std::numeric_limits<double>::infinity(), least_cpu = least;
  for (int i = 0; i < 5; ++i) {
    WriteLog(archive / fmt::format("dive_new/run_{}", i), kNumLogs + i + 1);
    const ChildResult run = Run(batch);
    least = std::min(least, run.seconds);
    least_cpu = std::min(least_cpu, run.cpu_seconds);
  }
  const bool holds = Report("One new log beside 3000",
                            least,
                            "s",
                            least <= kLongestNewLog,
                            fmt::format("at most {}", kLongestNewLog));
  Report("  of it CPU time", least_cpu, "s", true, "");
  return holds;
}

bool MeasureManyLogs(const fs::path& folder) {
  double peaks[2] = {};
  double rerun = std::numeric_limits<double>::infinity(), rerun_cpu = rerun;
  for (const int k : {0, 1}) {
    const int num_logs = k == 0 ? 100 : 1000;
    const fs::path archive = WriteArchive(folder / fmt::format("logs_{}", num_logs), num_logs);
    ChildCommand batch = Batch(archive, folder / fmt::format("logs_{}.sqlite", num_logs), 2);
    batch.arguments.push_back("--tools=" + (folder / "stubs").string());
    ChildCommand watched = batch;
    {
      std::vector<std::unique_ptr<PeakOf>> watch;
      watched.on_start = [&](int pid) { watch.push_back(std::make_unique<PeakOf>(pid)); };
      const ChildResult run = Run(watched);
      fmt::print(
          "{} logs, stubs: {:.2f} s, {:.2f} s of CPU\n", num_logs, run.seconds, run.cpu_seconds);
    }
    peaks[k] = PeakOf::Last();
    if (k == 0) continue;
    for (int i = 0; i < 5; ++i) {
      const ChildResult again = Run(batch);
      rerun = std::min(rerun, again.seconds);
      rerun_cpu = std::min(rerun_cpu, again.cpu_seconds);
    }
  }
  bool holds = Report("Rerun of 1000 logs with nothing new",
                      rerun,
                      "s",
                      rerun <= kLongestRerun,
                      fmt::format("at most {}", kLongestRerun));
  Report("  of it CPU time", rerun_cpu, "s", true, "");
  Report("Peak memory of the batch itself, 100 logs", peaks[0], "MB", true, "");
  holds &= Report("Peak memory of the batch itself, 1000 logs",
                  peaks[1],
                  "MB",
                  peaks[1] <= peaks[0] + kMostGrowth,
                  fmt::format("at most {:.1f}", peaks[0] + kMostGrowth));
  return holds;
}

}  // namespace
}  // namespace fathom

int main() {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("batch_bench_{}", getpid());
  std::filesystem::create_directories(folder);
  fathom::MakeStubs(folder / "stubs");
  const bool many = fathom::MeasureManyLogs(folder);
  const bool one_new = fathom::MeasureOneNewLog(folder);
  const bool real = fathom::MeasureRealPrograms(folder);
  std::filesystem::remove_all(folder);
  return many && one_new && real ? 0 : 1;
}
