// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A batch that is killed at any moment goes on from there, to the same results.

#include "fathom/process/run_child.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "batch_results.h"
#include "run_tool.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

namespace fathom {
namespace {

using Path = std::filesystem::path;

// 2 dives of 3 logs.
Path WriteExampleArchive(const Path& archive) {
  setenv("PATH", fmt::format("{}/tools:{}", FATHOM_BUILD_DIR, std::getenv("PATH")).c_str(), 1);
  const ChildResult made =
      RunChild({.program = FATHOM_SOURCE_DIR "/data/examples/example_archive.sh",
                .arguments = {archive.string(), "2", "3"}});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  return archive;
}

std::vector<std::string> FlagsOf(const Path& archive, const Path& results) {
  return {Flag("archive", archive),
          Flag("results", results),
          "--jobs=2",
          "--families=output_error",
          "--diagnose=false"};
}

// Processes with this text on their command line. A dead one that nobody has waited for has none.
std::vector<pid_t> ProcessesWith(const std::string& text) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const int pid = std::atoi(entry.path().filename().c_str());
    if (pid <= 0 || pid == getpid()) continue;
    // Of one that ends meanwhile the read fails: the stream notes that, its bare iterator throws.
    std::ifstream file(entry.path() / "cmdline", std::ios::binary);
    std::ostringstream line;
    line << file.rdbuf();
    if (line.str().find(text) != std::string::npos) found.push_back(pid);
  }
  return found;
}

// Which processes a kill is of.
enum class Killed { kParent, kAll, kChildren };

void Kill(Killed which, pid_t parent, const Path& archive) {
  if (which != Killed::kParent) {
    for (const pid_t pid : ProcessesWith(archive.string())) {
      if (pid != parent) kill(pid, SIGKILL);
    }
  }
  if (which != Killed::kChildren) kill(parent, SIGKILL);
}

// Runs the batch and kills after so many seconds; gives what became of it.
ToolRun RunAndKill(Killed which, double seconds, const Path& archive, const Path& results) {
  std::thread killer;
  const ToolRun run = RunToolBinary("fathom_batch", FlagsOf(archive, results), [&](int parent) {
    killer = std::thread([=, &archive] {
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
      Kill(which, parent, archive);
    });
  });
  killer.join();
  return run;
}

// A signal takes a moment to end a process.
std::vector<pid_t> SurvivorsOf(const Path& archive) {
  for (int i = 0; i < 200 && !ProcessesWith(archive.string()).empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return ProcessesWith(archive.string());
}

class KilledBatch : public testing::Test {
 protected:
  KilledBatch() {
    const auto start = std::chrono::steady_clock::now();
    const Path results = folder_ / "undisturbed.sqlite";
    RunsWell("fathom_batch", FlagsOf(archive_, results));
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    undisturbed_ = PublicRows(results);
  }

  void ExpectTheSameInTheEnd(const Path& results) {
    RunsWell("fathom_batch", FlagsOf(archive_, results));
    EXPECT_EQ(PublicRows(results), undisturbed_) << results;
    std::filesystem::remove(results);
  }

  const Path folder_ = EmptyTestFolder();
  const Path archive_ = WriteExampleArchive(folder_ / "archive");
  double seconds_ = 0.0;
  std::vector<std::string> undisturbed_;
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> share_{0.0, 1.0};
};

TEST_F(KilledBatch, GoesOnToTheSameResults) {
  // Four parameters of each of 6 logs and of each dive and DOF, scores, predictions.
  ASSERT_GT(undisturbed_.size(), 60u);
  constexpr int kChains = 15;
  int num_kills = 0;
  for (int chain = 0; chain < kChains; ++chain) {
    const Path results = folder_ / ("killed_" + std::to_string(chain) + ".sqlite");
    const Killed which = chain % 2 == 0 ? Killed::kParent : Killed::kAll;
    // The first kill, of a batch that began with nothing, falls into a fifteenth of the whole
    // duration; the second one into what is left of it, and is of the other kind every other time.
    const double first = (chain + share_(random_)) / kChains;
    const double second = share_(random_) * (1.0 - first);
    const Killed which_then = chain % 4 < 2 ? Killed::kAll : Killed::kParent;
    for (const auto& [killed, moment] : {std::pair{which, first}, std::pair{which_then, second}}) {
      SCOPED_TRACE(testing::Message() << results << ", killed after " << moment * seconds_ << " s");
      // One that is through before is killed earlier.
      for (double seconds = moment * seconds_; seconds > 1e-3; seconds *= 0.8) {
        const ToolRun run = RunAndKill(killed, seconds, archive_, results);
        EXPECT_THAT(SurvivorsOf(archive_), testing::IsEmpty());
        if (run.exit_code == 128 + SIGKILL) {
          ++num_kills;
          break;
        }
        ASSERT_EQ(run.exit_code, 0) << run.err;
        if (killed == which && moment == first) std::filesystem::remove(results);
      }
    }
    ExpectTheSameInTheEnd(results);
  }
  EXPECT_EQ(num_kills, 2 * kChains);
}

// As the kernel does that is short of memory. Those runs are made again, whichever they were.
TEST_F(KilledBatch, RunsAgainWhatWasKilledFromOutside) {
  constexpr int kKills = 6;
  for (int i = 0; i < kKills; ++i) {
    const Path results = folder_ / ("killed_" + std::to_string(i) + ".sqlite");
    const double moment = (i + share_(random_)) / kKills;
    SCOPED_TRACE(testing::Message() << "killed after " << moment * seconds_ << " s");
    RunsWell(RunAndKill(Killed::kChildren, moment * seconds_, archive_, results));
    ExpectTheSameInTheEnd(results);
  }
}

}  // namespace
}  // namespace fathom
