// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// An archive full of what goes wrong: each log in its state, the others as if the bad ones were not
// there.

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch_results.h"
#include "run_tool.h"
#include "small_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;
using Path = std::filesystem::path;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

// A small log with a digit of its own, so that it is no copy of another one.
Path WriteOwnLog(const Path& folder) {
  static int number = 0;
  WriteSmallLog(folder);
  WriteTestFile(folder / "velocity.csv",
                SmallVelocityCsv() + fmt::format("60.1,0.{:04d}\n", ++number));
  return folder;
}

// A small log of another motion: of the rows of SmallVelocityCsv() those with t up to `end`, with
// the speed of each from `speed`.
template <typename Speed>
std::string VelocityCsv(int num_rows, const Speed& speed) {
  std::string csv = "t,u\n";
  for (int row = 0; row < num_rows; ++row) csv += fmt::format("{:.1f},{}\n", 0.1 * row, speed(row));
  return csv;
}

Path UnrulyTools(const Path& folder) {
  fs::create_directories(folder);
  for (const char* verb : {"batch", "compare", "diagnose", "identify", "simulate", "track"}) {
    fs::create_symlink(FATHOM_UNRULY_TOOL, folder / (std::string("fathom_") + verb));
  }
  return folder;
}

ToolRun RunBatchOfBadLogs(const Path& archive,
                          const Path& results,
                          std::vector<std::string> more = {}) {
  std::vector<std::string> flags = {
      Flag("archive", archive), Flag("results", results), "--jobs=2", "--families=output_error"};
  if (std::find(more.begin(), more.end(), "--diagnose") == more.end()) {
    flags.push_back("--diagnose=false");
  }
  flags.insert(flags.end(), more.begin(), more.end());
  return RunToolBinary("fathom_batch", flags);
}

// Three logs of one dive, in order.
void WriteGoodLogs(const Path& archive) {
  for (int i = 1; i <= 3; ++i) {
    const Path folder = archive / "dive 1" / fmt::format("run {}", i);
    WriteSmallLog(folder);
    WriteTestFile(folder / "velocity.csv", SmallVelocityCsv() + fmt::format("60.1,0.{}\n", i));
  }
}

// What a batch with `more` makes of an archive of good logs and those that `write` adds: the state
// of each, after the good ones were compared with those of an archive of good ones alone.
template <typename Write>
std::map<std::string, std::string> StatesBesideGoodLogs(const Write& write,
                                                        std::vector<std::string> more = {}) {
  const Path folder = EmptyTestFolder();
  WriteGoodLogs(folder / "good");
  WriteGoodLogs(folder / "archive");
  write(folder / "archive");
  more.push_back("--tools=" + UnrulyTools(folder / "tools").string());
  RunsWell(RunBatchOfBadLogs(folder / "good", folder / "good.sqlite", more));
  const ToolRun run =
      RunsWell(RunBatchOfBadLogs(folder / "archive", folder / "archive.sqlite", more));
  const auto expected = PublicRows(folder / "good.sqlite");
  EXPECT_THAT(expected, testing::SizeIs(testing::Gt(10u)));
  EXPECT_THAT(PublicRows(folder / "archive.sqlite"), IsSupersetOf(expected));
  std::map<std::string, std::string> states = StatesOf(folder / "archive.sqlite");
  for (int i = 1; i <= 3; ++i) {
    const std::string path = fmt::format("dive 1/run {}", i);
    EXPECT_EQ(states[path], "ok: ");
    EXPECT_EQ(PublicRowsOf(path, folder / "archive.sqlite"),
              PublicRowsOf(path, folder / "good.sqlite"));
    states.erase(path);
  }
  // A rerun finds all of it done.
  const auto before = PublicRows(folder / "archive.sqlite");
  const ToolRun again = RunBatchOfBadLogs(folder / "archive", folder / "archive.sqlite", more);
  EXPECT_THAT(again.out, HasSubstr("0 logs run"));
  EXPECT_EQ(PublicRows(folder / "archive.sqlite"), before);
  return states;
}

// Each with a dive of its own, so that the dive of the good logs is theirs alone.
TEST(BadLogs, EndTheirOwnProgramsOnly) {
  const auto states = StatesBesideGoodLogs(
      [](const Path& archive) {
        for (const char* name : {"segfault",
                                 "segfault_batch",
                                 "segfault_identify",
                                 "hang",
                                 "hang_batch",
                                 "damage_identify"}) {
          WriteOwnLog(archive / name / name);
        }
        if (kLimitsMemory) WriteOwnLog(archive / "memory" / "memory");
      },
      {"--time_limit=4", "--memory_limit=1500"});
  EXPECT_EQ(states.at("segfault/segfault"),
            "crashed: surge, fathom_compare: crashed by signal 11 (Segmentation fault)");
  EXPECT_EQ(states.at("segfault_batch/segfault_batch"),
            "crashed: crashed by signal 11 (Segmentation fault)");
  EXPECT_EQ(states.at("segfault_identify/segfault_identify"), "ok: ");
  EXPECT_EQ(states.at("hang/hang"), "timed_out: surge, fathom_compare: killed at its time limit");
  EXPECT_EQ(states.at("hang_batch/hang_batch"), "timed_out: killed at its time limit");
  if (kLimitsMemory) {
    EXPECT_EQ(states.at("memory/memory"),
              "out_of_memory: surge, fathom_compare: failed at its memory limit");
  }
  const Path results = TestFolder() / "archive.sqlite";
  EXPECT_THAT(Query("SELECT message FROM dive_fits WHERE dive = 'segfault_identify'", results),
              testing::ElementsAre("crashed by signal 11 (Segmentation fault)"));
  EXPECT_EQ(states.at("damage_identify/damage_identify"), "ok: ");
  EXPECT_THAT(Query("SELECT message FROM dive_fits WHERE dive = 'damage_identify'", results),
              testing::ElementsAre(StartsWith("what it wrote: is not JSON")));
}

TEST(BadLogs, ArePartialWhereOneProgramFails) {
  const auto states = StatesBesideGoodLogs(
      [](const Path& archive) { WriteOwnLog(archive / "segfault_diagnose" / "segfault_diagnose"); },
      {"--diagnose"});
  EXPECT_EQ(states.at("segfault_diagnose/segfault_diagnose"),
            "partial: surge, fathom_diagnose: crashed by signal 11 (Segmentation fault)");
}

TEST(BadLogs, AreRunAgainWithOtherLimits) {
  const Path folder = EmptyTestFolder();
  const Path archive = folder / "archive", results = folder / "r.sqlite";
  WriteOwnLog(archive / "hang");
  if (kLimitsMemory) WriteOwnLog(archive / "memory");
  const std::string tools = "--tools=" + UnrulyTools(folder / "tools").string();
  RunBatchOfBadLogs(archive, results, {"--time_limit=0.5", "--memory_limit=1500", tools});
  EXPECT_THAT(StatesOf(results).at("hang"), StartsWith("timed_out: "));
  // The real programs now, which need no longer.
  const ToolRun same =
      RunBatchOfBadLogs(archive, results, {"--time_limit=0.5", "--memory_limit=1500"});
  EXPECT_THAT(same.out, HasSubstr("0 logs run"));
  RunBatchOfBadLogs(archive, results, {"--time_limit=60", "--memory_limit=1600"});
  for (const auto& [path, state] : StatesOf(results)) EXPECT_EQ(state, "ok: ") << path;
}

// An end at the limit of memory is told by the exit code alone where the last request was a large
// one: the process never came near the limit.
TEST(BadLogs, WithTenMillionRowsRunOutOfMemoryOrTime) {
  if (!kLimitsMemory) GTEST_SKIP() << "The address sanitizer takes no limit of memory.";
  const Path folder = EmptyTestFolder();
  const Path archive = folder / "archive", results = folder / "r.sqlite";
  std::string csv = "t,tau,v\n";
  csv.reserve(200'000'000);
  for (int row = 0; row < 10'000'000; ++row) {
    csv += fmt::format_int(row).str();
    csv += row % 80 < 40 ? ".0,20,0.25\n" : ".0,-20,-0.25\n";
  }
  WriteTestFile(archive / "archive.yaml", "dof: surge\n");
  WriteTestFile(archive / "long.csv", csv);
  csv = {};
  WriteOwnLog(archive / "short");
  RunBatchOfBadLogs(archive, results, {"--memory_limit=600", "--time_limit=60"});
  EXPECT_THAT(StatesOf(results).at("long.csv"), StartsWith("out_of_memory: "));
  EXPECT_EQ(StatesOf(results).at("short"), "ok: ");
  const ToolRun run =
      RunBatchOfBadLogs(archive, results, {"--memory_limit=4000", "--time_limit=0.3"});
  EXPECT_THAT(run.out, HasSubstr("1 log run"));
  EXPECT_THAT(StatesOf(results).at("long.csv"), StartsWith("timed_out: "));
  EXPECT_EQ(StatesOf(results).at("short"), "ok: ");
  fs::remove_all(archive);
}

TEST(BadLogs, ThatAreNoFilesAreNotOpened) {
  const auto states = StatesBesideGoodLogs([](const Path& archive) {
    mkfifo((archive / "pipe.csv").c_str(), 0644);
    fs::create_symlink("/dev/zero", archive / "device.csv");
    fs::create_directory_symlink(archive, archive / "dive 1" / "loop");
    fs::create_symlink("knot_b", archive / "knot_a");
    fs::create_symlink("knot_a", archive / "knot_b");
    fs::create_symlink("nowhere.csv", archive / "broken.csv");
    for (const char* name : {"pipe", "device", "pipe_yaml"}) WriteOwnLog(archive / name);
    fs::remove(archive / "pipe" / "command.csv");
    mkfifo((archive / "pipe" / "command.csv").c_str(), 0644);
    fs::remove(archive / "device" / "command.csv");
    fs::create_symlink("/dev/zero", archive / "device" / "command.csv");
    fs::remove(archive / "pipe_yaml" / "log.yaml");
    mkfifo((archive / "pipe_yaml" / "log.yaml").c_str(), 0644);
  });
  EXPECT_EQ(states.size(), 3u);
  EXPECT_THAT(states.at("pipe"),
              AllOf(StartsWith("unreadable: "), HasSubstr("pipe/command.csv: is a pipe")));
  EXPECT_THAT(states.at("device"),
              AllOf(StartsWith("unreadable: "), HasSubstr("device/command.csv: is a device")));
  EXPECT_THAT(states.at("pipe_yaml"),
              AllOf(StartsWith("unreadable: "), HasSubstr("pipe_yaml/log.yaml: is a pipe")));
  const Path folder = TestFolder();
  EXPECT_THAT(RunBatchOfBadLogs(folder / "archive", folder / "archive.sqlite", {"--dry_run"}).out,
              HasSubstr("6 other files that are no logs: 3 broken link, 1 device, 1 link to a "
                        "folder seen already, 1 pipe"));
}

TEST(BadLogs, SayWhatIsWrongWithTheirFiles) {
  const auto states = StatesBesideGoodLogs([](const Path& archive) {
    WriteTestFile(archive / "empty.csv", "");
    fs::create_directories(archive / "empty folder");
    WriteTestFile(archive / "empty yaml" / "log.yaml", "");
    WriteTestFile(archive / "empty command" / "log.yaml", "name: a\ndof: surge\n");
    WriteTestFile(archive / "empty command" / "command.csv", "");
    WriteTestFile(archive / "empty command" / "velocity.csv", SmallVelocityCsv());
    WriteTestFile(archive / "bytes in yaml" / "log.yaml", "name: \xff\xfe\n");
    WriteOwnLog(archive / "bytes in csv");
    WriteTestFile(archive / "bytes in csv" / "command.csv", "t,tau_surge\n0.0,\xff\xfe\n0.1,2\n");
    WriteTestFile(archive / "header only.csv", "t,tau,v\n");
  });
  EXPECT_THAT(states.at("empty yaml"), StartsWith("refused: "));
  EXPECT_THAT(states.at("empty command"), AllOf(StartsWith("refused: "), HasSubstr("command.csv")));
  EXPECT_THAT(states.at("bytes in yaml"), AllOf(StartsWith("refused: "), HasSubstr("log.yaml")));
  EXPECT_THAT(states.at("bytes in csv"),
              AllOf(StartsWith("refused: "), HasSubstr("command.csv"), HasSubstr("\\xff\\xfe")));
  EXPECT_THAT(states.at("header only.csv"), StartsWith("refused: "));
  EXPECT_EQ(states.count("empty.csv"), 0u);  // nothing in it says that it is a log
  EXPECT_EQ(states.size(), 5u);
}

TEST(BadLogs, ThatCannotIdentifyAnythingSayWhy) {
  const auto states = StatesBesideGoodLogs([](const Path& archive) {
    WriteOwnLog(archive / "rest" / "a");
    WriteTestFile(archive / "rest" / "a" / "velocity.csv",
                  VelocityCsv(601, [](int) { return 0.25; }));
    WriteOwnLog(archive / "no command" / "a");
    fs::remove(archive / "no command" / "a" / "command.csv");
    WriteOwnLog(archive / "short" / "a");
    WriteTestFile(archive / "short" / "a" / "velocity.csv",
                  VelocityCsv(25, [](int row) { return 0.01 * row * row; }));
    WriteOwnLog(archive / "constant" / "a");
    std::string command = "t,tau_surge\n";
    for (int row = 0; row <= 600; ++row) command += fmt::format("{:.1f},20\n", 0.1 * row);
    WriteTestFile(archive / "constant" / "a" / "command.csv", command);
    WriteSmallLog(archive / "copies" / "a");
    WriteSmallLog(archive / "copies" / "b");
  });
  EXPECT_EQ(states.at("rest/a"), "nothing_to_identify: surge: at rest: the motion never changes.");
  EXPECT_EQ(states.at("no command/a"), "nothing_to_identify: surge: no command.");
  // 25 samples at 10 Hz, 2.4 s.
  EXPECT_EQ(states.at("short/a"),
            "nothing_to_identify: surge: too short: 25 samples over 2.4 s, expected at least 20 "
            "over 3 s.");
  EXPECT_EQ(states.at("constant/a"),
            "nothing_to_identify: surge: the command never changes: it is 20 N throughout.");
  EXPECT_EQ(states.at("copies/a"), "ok: ");
  EXPECT_EQ(states.at("copies/b"), "duplicate: the same bytes as copies/a.");
}

TEST(BadLogs, MayBeCalledAnything) {
  const std::vector<std::string> names = {"données été",
                                          "データ 1",
                                          "водолаз",
                                          "قارب",
                                          "a, b",
                                          "it's \"so\"",
                                          "two\nlines",
                                          "-- ; DROP TABLE logs",
                                          "\xff\xfe",
                                          "back\\slash",
                                          "%s$HOME`id`",
                                          "--help"};
  const auto states = StatesBesideGoodLogs([&](const Path& archive) {
    for (const std::string& name : names) WriteOwnLog(archive / name / "log");
  });
  std::vector<std::string> paths;
  for (const auto& [path, state] : states) {
    EXPECT_EQ(state, "ok: ") << path;
    paths.push_back(path.substr(0, path.rfind('/')));
  }
  // Bytes that are no text, and control characters, as \x..; a backslash as two.
  EXPECT_THAT(paths,
              testing::UnorderedElementsAre("données été",
                                            "データ 1",
                                            "водолаз",
                                            "قارب",
                                            "a, b",
                                            "it's \"so\"",
                                            "two\\x0alines",
                                            "-- ; DROP TABLE logs",
                                            "\\xff\\xfe",
                                            "back\\\\slash",
                                            "%s$HOME`id`",
                                            "--help"));
  const Path results = TestFolder() / "archive.sqlite";
  EXPECT_THAT(Query("SELECT DISTINCT usable FROM dive_fits", results), testing::ElementsAre("1"));
}

TEST(BadLogs, InAFolderThatCannotBeReadAreTold) {
  if (geteuid() == 0) GTEST_SKIP() << "Root reads every folder.";
  const auto states = StatesBesideGoodLogs([](const Path& archive) {
    WriteOwnLog(archive / "locked" / "a");
    WriteOwnLog(archive / "locked file");
    fs::permissions(archive / "locked", fs::perms::none);
    fs::permissions(archive / "locked file" / "command.csv", fs::perms::none);
  });
  EXPECT_EQ(states.at("locked"), "unreadable: the folder cannot be read: Permission denied");
  EXPECT_THAT(states.at("locked file"),
              AllOf(StartsWith("unreadable: "), HasSubstr("Permission denied")));
  const Path folder = TestFolder();
  fs::permissions(folder / "archive" / "locked", fs::perms::owner_all);
}

}  // namespace
}  // namespace fathom
