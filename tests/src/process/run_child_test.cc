// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/process/run_child.h"

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fathom {
namespace {

ChildResult RunShell(const std::string& script, const ChildLimits& limits = {}) {
  return RunChild({.program = "sh", .arguments = {"-c", script}, .limits = limits});
}

bool IsAlive(pid_t pid) {
  if (kill(pid, 0) != 0) return false;
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string line;  // Stays empty where the process ends before it is read.
  std::getline(stat, line);
  return !line.empty() && line.find(") Z") == std::string::npos;
}

bool DiesWithin(double seconds, pid_t pid) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (IsAlive(pid) && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return !IsAlive(pid);
}

TEST(RunChild, GivesBackExitCodeAndBothOutputs) {
  const ChildResult result = RunShell("echo result; echo complaint >&2; exit 7");
  EXPECT_EQ(result.end, ChildEnd::kExited);
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_EQ(result.signal, 0);
  EXPECT_EQ(result.out, "result\n");
  EXPECT_EQ(result.err, "complaint\n");
  EXPECT_GT(result.seconds, 0.0);
  EXPECT_GT(result.peak_memory, 1e5);
}

TEST(RunChild, PassesArgumentsAsTheyAre) {
  const ChildResult result =
      RunChild({.program = "printf", .arguments = {"%s|", "a b", "", "$HOME", "ü,'\"\n"}});
  EXPECT_EQ(result.out, "a b||$HOME|ü,'\"\n|");
}

TEST(RunChild, GivesItAnEmptyInput) { EXPECT_EQ(RunShell("wc -c").out, "0\n"); }

TEST(RunChild, WaitsForOneThatClosesItsOutputsFirst) {
  const ChildResult result = RunShell("echo result; exec >&- 2>&-; sleep 0.1; exit 7");
  EXPECT_EQ(result.out, "result\n");
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_GE(result.seconds, 0.1);
}

TEST(RunChild, TellsWhichSignalEndedIt) {
  const ChildResult result = RunShell("kill -SEGV $$");
  EXPECT_EQ(result.end, ChildEnd::kSignalled);
  EXPECT_EQ(result.signal, SIGSEGV);
  EXPECT_EQ(result.exit_code, 128 + SIGSEGV);
}

TEST(RunChild, TellsWhyAProgramDoesNotStart) {
  const ChildResult result = RunChild({.program = "/nowhere/at/all", .arguments = {}});
  EXPECT_EQ(result.end, ChildEnd::kNotStarted);
  EXPECT_EQ(result.err, "No such file or directory");
}

TEST(RunChild, KillsWhatHangsAndAllThatItStarted) {
  const ChildResult result = RunShell(
      "trap '' TERM INT; sleep 100 & echo $!; echo on its way >&2; "
      "wait",
      {.wall_time = 0.3});
  EXPECT_EQ(result.end, ChildEnd::kTimedOut);
  EXPECT_EQ(result.err, "on its way\n");
  EXPECT_LT(result.seconds, 5.0);
  EXPECT_TRUE(DiesWithin(5.0, std::stoi(result.out)));
}

TEST(RunChild, DoesNotWaitForWhatItsChildLeftBehind) {
  const ChildResult result = RunShell("sleep 100 & echo $!");
  EXPECT_EQ(result.end, ChildEnd::kExited);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_LT(result.seconds, 5.0);
  EXPECT_TRUE(DiesWithin(5.0, std::stoi(result.out)));
}

TEST(RunChild, EndsWhatUsesUpItsCpuTime) {
  const ChildResult result = RunShell("while :; do :; done", {.wall_time = 30.0, .cpu_time = 1.0});
  EXPECT_EQ(result.end, ChildEnd::kTimedOut);
  EXPECT_LT(result.seconds, 20.0);
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(RunChild, EndsWhatEatsMemory) {
  // tail keeps a whole line.
  const ChildResult result =
      RunShell("exec tail -n 1 /dev/zero", {.wall_time = 30.0, .memory = 2e8});
  EXPECT_EQ(result.end, ChildEnd::kOutOfMemory);
  EXPECT_LT(result.peak_memory, 2e8);
}
#endif

TEST(RunChild, LeavesAFailureWithinTheMemoryLimitAFailure) {
  const ChildResult result = RunShell("exit 1", {.memory = 1e9});
  EXPECT_EQ(result.end, ChildEnd::kExited);
  EXPECT_EQ(result.exit_code, 1);
}

TEST(RunChild, KeepsTheEndOfAnEndlessOutput) {
  const ChildResult result = RunChild({.program = "sh",
                                       .arguments = {"-c", "seq 1000000; echo last >&2"},
                                       .limits = {},
                                       .most_output = 1000});
  EXPECT_EQ(result.out.size(), 1000u);
  EXPECT_TRUE(result.out.ends_with("999999\n1000000\n"));
  EXPECT_EQ(result.err, "last\n");
}

TEST(RunChild, RunsManyAtOnce) {
  std::vector<std::thread> threads;
  std::vector<ChildResult> results(16);
  for (int i = 0; i < 16; ++i) {
    threads.emplace_back(
        [i, &results] { results[i] = RunShell("sleep 0.05; exit " + std::to_string(i)); });
  }
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < 16; ++i) EXPECT_EQ(results[i].exit_code, i);
}

TEST(RunChild, TakesItsChildAlongWhenItIsKilled) {
  std::array<int, 2> ends = {};
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t parent = fork();
  ASSERT_GE(parent, 0);
  if (parent == 0) {
    const std::string script = "echo $$ > /dev/fd/" + std::to_string(ends[1]) + "; exec sleep 100";
    RunShell(script);
    _exit(0);
  }
  std::array<char, 32> text = {};
  ASSERT_GT(read(ends[0], text.data(), text.size() - 1), 0);
  const pid_t grandchild = std::stoi(text.data());
  EXPECT_TRUE(IsAlive(grandchild));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(DiesWithin(5.0, grandchild));
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace fathom
