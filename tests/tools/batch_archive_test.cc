// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a batch takes from an archive, leaves alone in it and does again.

#include "fathom/process/run_child.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "batch_results.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "small_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Path = std::filesystem::path;

ToolRun RunBatch(const Path& archive, const Path& results, std::vector<std::string> more = {}) {
  std::vector<std::string> flags = {Flag("archive", archive),
                                    Flag("results", results),
                                    "--families=output_error",
                                    "--diagnose=false"};
  flags.insert(flags.end(), more.begin(), more.end());
  return RunToolBinary("fathom_batch", flags);
}

// A small log with a last row of its own.
Path WriteLog(const Path& folder, int number, const std::string& yaml = "") {
  WriteSmallLog(folder);
  WriteTestFile(folder / "velocity.csv", SmallVelocityCsv() + fmt::format("60.1,0.{}\n", number));
  WriteTestFile(folder / "log.yaml", "name: small\ndof: surge\n" + yaml);
  return folder;
}

Path WriteCsvLog(const Path& file, int number) {
  return WriteTestFile(file, SmallSingleCsv() + fmt::format("60.1,8.0,0.{}\n", number));
}

// Two dives of two logs.
Path WriteArchive(const Path& archive) {
  for (int i = 0; i < 4; ++i) {
    WriteLog(archive / fmt::format("dive {}/run {}", i / 2 + 1, i % 2 + 1), i + 1);
  }
  return archive;
}

// Names, sizes, times of change of content and of the entry itself, down from a folder.
std::vector<std::string> StampsOf(const Path& folder) {
  std::vector<std::string> stamps;
  const auto add = [&](const Path& path) {
    struct stat status = {};
    lstat(path.c_str(), &status);
    stamps.push_back(fmt::format("{} {} {}.{} {}.{}",
                                 path.string(),
                                 status.st_size,
                                 status.st_mtim.tv_sec,
                                 status.st_mtim.tv_nsec,
                                 status.st_ctim.tv_sec,
                                 status.st_ctim.tv_nsec));
  };
  add(folder);
  for (const auto& entry : fs::recursive_directory_iterator(folder)) add(entry.path());
  std::sort(stamps.begin(), stamps.end());
  return stamps;
}

std::string DivesIn(const Path& results) {
  std::string dives;
  for (const std::string& row : Query("SELECT path, dive FROM logs ORDER BY path", results)) {
    dives += row + "\n";
  }
  return dives;
}

class Batch : public ::testing::Test {
 protected:
  // Those of a batch that knows nothing yet of the archive as it is now.
  void ExpectTheRowsOfAFreshBatch() const {
    const auto rows = PublicRows(results_);
    fs::remove(results_);
    RunsWell(RunBatch(archive_, results_));
    EXPECT_EQ(rows, PublicRows(results_));
  }

  const Path folder_ = EmptyTestFolder();
  const Path archive_ = folder_ / "archive", results_ = folder_ / "r.sqlite";
};

TEST_F(Batch, WritesNothingIntoTheArchive) {
  WriteArchive(archive_);
  const auto before = StampsOf(archive_);
  const ToolRun run = RunsWell("fathom_batch",
                               {Flag("archive", archive_),
                                Flag("results", results_),
                                Flag("report", folder_ / "r.html"),
                                "--pages",
                                "--jobs=2"});
  EXPECT_EQ(StatesOf(results_).at("dive 1/run 1"), "ok: ");
  EXPECT_EQ(StampsOf(archive_), before);
}

TEST_F(Batch, ReadsAnArchiveThatCannotBeWritten) {
  WriteArchive(archive_);
  const std::string mounted = (folder_ / "mounted").string();
  fs::create_directory(mounted);
  const auto mount = [](std::vector<std::string> arguments) {
    return RunChild({.program = "mount", .arguments = std::move(arguments)}).exit_code == 0;
  };
  if (!mount({"--bind", archive_.string(), mounted}))
    GTEST_SKIP() << "Nothing can be mounted here.";
  const bool is_read_only = mount({"-o", "remount,bind,ro", mounted});
  const ToolRun run = RunBatch(mounted, results_);
  RunChild({.program = "umount", .arguments = {mounted}});
  if (!is_read_only) GTEST_SKIP() << "Nothing can be mounted read-only here.";
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("4 logs in 2 dives: 4 ok"));
}

TEST_F(Batch, RefusesToWriteIntoTheArchive) {
  WriteArchive(archive_);
  fs::create_directory_symlink(archive_, folder_ / "link");
  const auto before = StampsOf(archive_);
  for (const Path& place : {archive_ / "x", archive_ / "dive 1" / "x", folder_ / "link" / "x"}) {
    const ToolRun run = RunBatch(archive_, place);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.err,
              fmt::format("fathom_batch: --results={}: lies in the archive, into which nothing is "
                          "written, expected a place elsewhere.\n",
                          place.string()));
    for (const std::string flag : {"report", "csv", "slurm"}) {
      const ToolRun other =
          RunBatch(archive_, results_, {"--" + flag + "=" + place.string(), "--plan=2"});
      EXPECT_EQ(other.exit_code, 1);
      EXPECT_THAT(other.err,
                  HasSubstr("--" + flag + "=" + place.string() + ": lies in the archive"));
    }
  }
  EXPECT_EQ(StampsOf(archive_), before);
}

TEST_F(Batch, IsTheOnlyOneThatWritesItsResults) {
  WriteLog(archive_ / "hang", 1);
  for (const char* verb : {"batch", "compare", "identify"}) {
    fs::create_directories(folder_ / "tools");
    fs::create_symlink(FATHOM_UNRULY_TOOL, folder_ / "tools" / (std::string("fathom_") + verb));
  }
  ToolRun second;
  const ToolRun first = RunToolBinary("fathom_batch",
                                      {Flag("archive", archive_),
                                       Flag("results", results_),
                                       "--families=output_error",
                                       "--diagnose=false",
                                       "--time_limit=2",
                                       Flag("tools", folder_ / "tools")},
                                      [&](int) {
                                        // It is made once the lock is held.
                                        while (!fs::exists(results_.string() + ".work")) {
                                          std::this_thread::sleep_for(std::chrono::milliseconds(5));
                                        }
                                        second = RunBatch(archive_, results_);
                                      });
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_EQ(second.err,
            fmt::format("fathom_batch: --results={}: another batch is writing it, expected one at "
                        "a time.\n",
                        results_.string()));
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(StatesOf(results_).at("hang"), StartsWith("timed_out: "));
}

// A program in place of a tool: the lines, then the tool itself.
void WriteWrappedTool(const Path& tools, const std::string& name, const std::string& lines) {
  const Path file = WriteTestFile(
      tools / name,
      fmt::format("#!/bin/sh\n{}\nexec '{}/tools/{}' \"$@\"\n", lines, FATHOM_BUILD_DIR, name));
  fs::permissions(file, fs::perms::owner_all);
}

// The last log does not end before the first dive is fitted.
TEST_F(Batch, FitsADiveWhileALogOfALaterOneIsRunning) {
  const Path tools = folder_ / "tools";
  for (int i = 1; i <= 3; ++i) WriteLog(archive_ / fmt::format("dive {}/run", i), i);
  const Path fitted = folder_ / "fitted", in_vain = folder_ / "in vain";
  WriteWrappedTool(tools, "fathom_batch", "");
  WriteWrappedTool(tools, "fathom_simulate", "");
  WriteWrappedTool(tools, "fathom_identify", fmt::format("touch '{}'", fitted.string()));
  WriteWrappedTool(tools,
                   "fathom_compare",
                   fmt::format("case \"$*\" in *'dive 3'*)\n"
                               "  for i in $(seq 200); do [ -e '{0}' ] || sleep 0.1; done\n"
                               "  [ -e '{0}' ] || touch '{1}';;\n"
                               "esac",
                               fitted.string(),
                               in_vain.string()));
  RunsWell(RunBatch(archive_, results_, {"--jobs=2", Flag("tools", tools)}));
  EXPECT_TRUE(fs::exists(fitted));
  EXPECT_FALSE(fs::exists(in_vain));
  EXPECT_THAT(
      Query("SELECT dive FROM dive_fits WHERE parameter = 'inertia' ORDER BY dive", results_),
      ElementsAre("dive 1", "dive 2", "dive 3"));
  ExpectTheRowsOfAFreshBatch();
}

TEST_F(Batch, IsStrictWhereAskedTo) {
  WriteArchive(archive_);
  RunsWell(RunBatch(archive_, results_, {"--strict"}));
  WriteTestFile(archive_ / "bad" / "log.yaml", "depth: 3\n");
  RunsWell(RunBatch(archive_, results_));
  EXPECT_EQ(RunBatch(archive_, results_, {"--strict"}).exit_code, 3);
}

TEST_F(Batch, RunsNothingInADryRun) {
  WriteArchive(archive_);
  const ToolRun before = RunBatch(archive_, results_, {"--dry_run"});
  EXPECT_EQ(before.out, "4 logs, 4 to do\n4 logs new\n");
  EXPECT_THAT(Query("SELECT * FROM runs", results_), testing::IsEmpty());
  EXPECT_THAT(Query("SELECT * FROM logs", results_), testing::IsEmpty());
  RunBatch(archive_, results_);
  EXPECT_EQ(RunBatch(archive_, results_, {"--dry_run"}).out, "4 logs, 0 to do\n");
  WriteLog(archive_ / "dive 2" / "run 2", 7);
  const auto runs = Query("SELECT * FROM runs", results_);
  EXPECT_EQ(RunBatch(archive_, results_, {"--dry_run"}).out,
            "4 logs, 1 to do\n1 log changed, or done with other options\n");
  EXPECT_EQ(Query("SELECT * FROM runs", results_), runs);
}

TEST_F(Batch, TakesDivesFromTheFolders) {
  WriteLog(archive_ / "cruise a" / "2024-05-01 dive" / "run", 1);
  WriteLog(archive_ / "cruise b" / "2024-05-02 dive" / "run", 2);
  WriteLog(archive_ / "cruise b" / "run", 3);
  RunBatch(archive_, results_);
  EXPECT_EQ(DivesIn(results_),
            "cruise a/2024-05-01 dive/run|cruise a/2024-05-01 dive\n"
            "cruise b/2024-05-02 dive/run|cruise b/2024-05-02 dive\n"
            "cruise b/run|cruise b\n");
  WriteTestFile(archive_ / "archive.yaml", "dive_level: 1\n");
  RunBatch(archive_, results_);
  EXPECT_EQ(DivesIn(results_),
            "cruise a/2024-05-01 dive/run|cruise a\n"
            "cruise b/2024-05-02 dive/run|cruise b\n"
            "cruise b/run|cruise b\n");
  EXPECT_THAT(Query("SELECT DISTINCT dive, logs FROM dive_fits", results_),
              ElementsAre("cruise a|1", "cruise b|2"));
  // A path without a match is a dive of its own.
  WriteTestFile(archive_ / "archive.yaml", "dive_pattern: '[0-9]{4}-[0-9]{2}-[0-9]{2}'\n");
  RunBatch(archive_, results_);
  EXPECT_EQ(DivesIn(results_),
            "cruise a/2024-05-01 dive/run|2024-05-01\n"
            "cruise b/2024-05-02 dive/run|2024-05-02\n"
            "cruise b/run|cruise b/run\n");
  ExpectTheRowsOfAFreshBatch();
}

TEST_F(Batch, TakesDivesAndStartsFromTheLogs) {
  WriteLog(archive_ / "x", 1, "dive: west\nstart: 2024-05-02T10:00:00Z\n");
  WriteLog(archive_ / "y", 2, "dive: west\nstart: 2024-05-02T11:00:00Z\n");
  WriteLog(archive_ / "z", 3, "dive: east\nstart: 2024-05-01T10:00:00Z\n");
  RunBatch(archive_, results_);
  EXPECT_THAT(Query("SELECT path, dive, start FROM logs ORDER BY path", results_),
              ElementsAre("x|west|2024-05-02T10:00:00Z",
                          "y|west|2024-05-02T11:00:00Z",
                          "z|east|2024-05-01T10:00:00Z"));
  // The dive of May 1 predicts the logs of May 2, though its name comes last by the path.
  EXPECT_THAT(Query("SELECT model_log, log FROM predictions ORDER BY log", results_),
              ElementsAre("east|x", "east|y"));
  // A start that is corrected turns them round.
  WriteLog(archive_ / "z", 3, "dive: east\nstart: 2024-05-03T10:00:00Z\n");
  RunBatch(archive_, results_);
  EXPECT_THAT(Query("SELECT model_log, log FROM predictions", results_), ElementsAre("west|z"));
}

TEST_F(Batch, LeavesOutWhatItIsTold) {
  WriteArchive(archive_);
  RunBatch(archive_, results_);
  WriteTestFile(archive_ / "archive.yaml", "leave_out: [dive 1, '*/run 2']\n");
  const ToolRun run = RunBatch(archive_, results_);
  EXPECT_THAT(run.out, AllOf(HasSubstr("1 log in 1 dive: 1 ok"), HasSubstr("2 left out")));
  EXPECT_EQ(DivesIn(results_), "dive 2/run 1|dive 2\n");
  ExpectTheRowsOfAFreshBatch();
}

TEST_F(Batch, TakesTheDofOfSingleFilesFromTheArchive) {
  WriteCsvLog(archive_ / "dive" / "a.csv", 1);
  RunBatch(archive_, results_);
  EXPECT_THAT(StatesOf(results_).at("dive/a.csv"), StartsWith("refused: "));
  WriteTestFile(archive_ / "archive.yaml", "dof: heave\n");
  RunBatch(archive_, results_);
  EXPECT_EQ(StatesOf(results_).at("dive/a.csv"), "ok: ");
  EXPECT_THAT(Query("SELECT DISTINCT dof, usable FROM fits", results_), ElementsAre("heave|1"));
  EXPECT_THAT(Query("SELECT DISTINCT dof, usable FROM dive_fits", results_),
              ElementsAre("heave|1"));
}

// They were taken and had no effect.
TEST_F(Batch, RefusesFlagsOfOneLogAndFoldersWithoutPrograms) {
  WriteArchive(archive_);
  const auto refusal = [&](const std::string& flag) {
    const ToolRun run = RunBatch(archive_, results_, {flag});
    EXPECT_EQ(run.exit_code, 1) << flag;
    return run.err;
  };
  EXPECT_THAT(refusal("--dof=surge"), HasSubstr("`dof:` in archive.yaml"));
  EXPECT_THAT(refusal("--default_vehicle=rov.yaml"), HasSubstr("`vehicle:` in archive.yaml"));
  EXPECT_THAT(refusal("--tools=" + archive_.string()), HasSubstr("holds no fathom_compare"));
  EXPECT_FALSE(std::filesystem::exists(results_));
}

TEST_F(Batch, RefusesSettingsThatItDoesNotKnow) {
  WriteArchive(archive_);
  const std::string file = (archive_ / "archive.yaml").string();
  const auto refusal = [&](const std::string& yaml) {
    WriteTestFile(file, "# the archive of a test\n" + yaml);
    const ToolRun run = RunBatch(archive_, results_);
    EXPECT_EQ(run.exit_code, 1) << yaml;
    return run.err;
  };
  const std::string at = "fathom_batch: " + file + ":2: ";
  EXPECT_THAT(refusal("dive_levels: 1\n"), AllOf(StartsWith(at), HasSubstr("dive_levels")));
  EXPECT_EQ(
      refusal("dive_level: 0\n"),
      at + "key 'dive_level' is 0, expected a level of the path, from 1 on: 1 is the folder in "
           "the archive itself.\n");
  EXPECT_EQ(refusal("dive_pattern: '(['\n"),
            at + "key 'dive_pattern' is '([', expected a regular expression as "
                 "[0-9]{4}-[0-9]{2}-[0-9]{2}.\n");
  EXPECT_EQ(refusal("dof: forward\n"),
            at + "key 'dof' is 'forward', expected surge, sway, heave, roll, pitch or yaw.\n");
  EXPECT_THAT(refusal("leave_out: {a: b}\n"), AllOf(StartsWith(at), HasSubstr("leave_out")));
  EXPECT_THAT(refusal("dive_level: one\n"), AllOf(StartsWith(at), HasSubstr("dive_level")));
  EXPECT_THAT(refusal("dive_level: 1\ndive_pattern: a\n"),
              HasSubstr(":3: key 'dive_pattern' stands beside dive_level"));
  EXPECT_FALSE(std::filesystem::exists(results_));
}

TEST_F(Batch, DoesAChangedLogAgainAndNoOther) {
  WriteArchive(archive_);
  RunBatch(archive_, results_);
  const auto runs_of = [&](const std::string& program) {
    return Query("SELECT arguments FROM runs WHERE program = '" + program + "'", results_).size();
  };
  EXPECT_EQ(runs_of("fathom_compare"), 4u);
  EXPECT_EQ(runs_of("fathom_identify"), 2u);
  const auto seconds = Query("SELECT path, seconds FROM logs ORDER BY path", results_);
  WriteLog(archive_ / "dive 1" / "run 2", 9);
  EXPECT_THAT(RunBatch(archive_, results_).out, HasSubstr("1 log run"));
  EXPECT_EQ(runs_of("fathom_compare"), 5u);
  EXPECT_EQ(runs_of("fathom_identify"), 3u);
  const auto then = Query("SELECT path, seconds FROM logs ORDER BY path", results_);
  ASSERT_EQ(then.size(), 4u);
  for (const std::size_t i : {0u, 2u, 3u}) EXPECT_EQ(then[i], seconds[i]);
  EXPECT_NE(then[1], seconds[1]);
  // Touched, and not changed.
  fs::last_write_time(archive_ / "dive 1" / "run 1" / "velocity.csv",
                      fs::file_time_type::clock::now());
  EXPECT_THAT(RunBatch(archive_, results_).out, HasSubstr("0 logs run"));
  ExpectTheRowsOfAFreshBatch();
}

// What the programs wrote of logs that are done is not read again: it could as well be damaged.
TEST_F(Batch, TakesLogsThatAreDoneFromItsTables) {
  WriteArchive(archive_);
  WriteLog(archive_ / "dive 0" / "run 1", 5, "dive: dive 1\nvehicle: pike\n");
  WriteLog(archive_ / "dive 0" / "run 2", 5, "dive: dive 1\nvehicle: pike\n");  // a copy
  WriteTestFile(archive_ / "dive 2/at rest/log.yaml", "name: rest\ndof: surge\n");
  WriteTestFile(archive_ / "dive 2/at rest/command.csv", "t,tau_surge\n0,0\n1,0\n");
  WriteTestFile(archive_ / "dive 2/at rest/velocity.csv", "t,u\n0,0\n1,0\n");
  RunBatch(archive_, results_);
  Query("UPDATE runs SET output = '' WHERE program IN ('fathom_batch', 'fathom_compare')",
        results_);
  WriteLog(archive_ / "dive 2" / "run 3", 6);
  EXPECT_THAT(RunBatch(archive_, results_).out, HasSubstr("1 log run now, 7 done before"));
  ExpectTheRowsOfAFreshBatch();
}

TEST_F(Batch, ForgetsALogThatIsGone) {
  WriteArchive(archive_);
  WriteSmallLog(archive_ / "dive 3" / "a");
  WriteSmallLog(archive_ / "dive 3" / "b");
  RunBatch(archive_, results_);
  EXPECT_EQ(StatesOf(results_).at("dive 3/b"), "duplicate: the same bytes as dive 3/a.");
  fs::remove_all(archive_ / "dive 1" / "run 1");
  fs::remove_all(archive_ / "dive 2");
  fs::remove_all(archive_ / "dive 3" / "a");  // its copy is the first one now
  EXPECT_THAT(RunBatch(archive_, results_).out, HasSubstr("2 logs in 2 dives: 2 ok"));
  EXPECT_EQ(DivesIn(results_), "dive 1/run 2|dive 1\ndive 3/b|dive 3\n");
  ExpectTheRowsOfAFreshBatch();
}

TEST_F(Batch, ForgetsAnArchiveThatIsEmptyNow) {
  WriteArchive(archive_);
  RunBatch(archive_, results_);
  fs::remove_all(archive_);
  fs::create_directory(archive_);
  EXPECT_THAT(RunBatch(archive_, results_).out, HasSubstr("0 logs: nothing found"));
  EXPECT_THAT(PublicRows(results_), testing::IsEmpty());
}

TEST_F(Batch, LeavesNothingOfAnArchiveWithoutLogs) {
  WriteTestFile(archive_ / "notes.txt", "no log");
  EXPECT_THAT(ExpectRefusal(
                  "fathom_batch", {Flag("archive", archive_), Flag("results", results_)}, folder_),
              HasSubstr(archive_.string() + ": holds no log (but 1 .txt), expected"));
}

TEST_F(Batch, TakesTheNameOfTheVehicleFromItsFile) {
  WriteArchive(archive_);
  WriteTestFile(archive_ / "archive.yaml", "vehicle: v.yaml\n");
  WriteTestFile(archive_ / "v.yaml", SmallVehicleYaml());
  RunBatch(archive_, results_);
  EXPECT_THAT(Query("SELECT DISTINCT vehicle FROM logs", results_), ElementsAre("small"));
  std::string renamed = SmallVehicleYaml();
  renamed.replace(renamed.find("small"), 5, "other");
  WriteTestFile(archive_ / "v.yaml", renamed);
  EXPECT_THAT(RunBatch(archive_, results_).out, HasSubstr("0 logs run"));
  EXPECT_THAT(Query("SELECT DISTINCT vehicle FROM logs", results_), ElementsAre("other"));
  EXPECT_THAT(Query("SELECT DISTINCT vehicle FROM dive_fits", results_), ElementsAre("other"));
}

TEST_F(Batch, RunsAgainWhatDidNotStart) {
  WriteArchive(archive_);
  WriteTestFile(folder_ / "no tools" / "fathom_compare", "no program\n");
  RunBatch(archive_, results_, {Flag("tools", folder_ / "no tools")});
  EXPECT_EQ(StatesOf(results_).at("dive 1/run 1"),
            "refused: did not start: No such file or directory");
  RunBatch(archive_, results_);
  ExpectTheRowsOfAFreshBatch();
}

TEST_F(Batch, WritesTheFitsAsCsv) {
  WriteLog(archive_ / "a, \"b\"" / "run", 1);
  RunBatch(archive_, results_, {Flag("csv", folder_ / "fits.csv")});
  std::ifstream file(folder_ / "fits.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0], "log,dof,family,source,usable,parameter,value,std,unit,message");
  const std::vector<std::string> values =
      Query("SELECT parameter FROM fits ORDER BY rowid", results_);
  ASSERT_EQ(values.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_THAT(
        lines[i + 1],
        StartsWith("\"a, \"\"b\"\"/run\",surge,output_error,pose_estimator,1," + values[i] + ","));
  }
}

// A CSV of two columns with the second one times a factor.
void Scale(const Path& csv, double factor) {
  std::ifstream in(csv);
  std::string scaled, line;
  std::getline(in, scaled);
  scaled += "\n";
  while (std::getline(in, line)) {
    const std::size_t comma = line.find(',');
    scaled +=
        fmt::format("{},{}\n", line.substr(0, comma), factor * std::stod(line.substr(comma + 1)));
  }
  WriteTestFile(csv, scaled);
}

// One of another, lighter vehicle, which moves more than the others and would dominate them, and
// one whose command has the wrong sign.
TEST_F(Batch, LeavesOutOfTheFitOfADiveWhatSpoilsIt) {
  for (int i = 1; i <= 3; ++i) WriteLog(archive_ / "dive" / fmt::format("run {}", i), i);
  Scale(WriteLog(archive_ / "dive/other", 4) / "velocity.csv", 5.0);
  Scale(WriteLog(archive_ / "dive/reversed", 5) / "command.csv", -1.0);
  RunsWell(RunBatch(archive_, results_));
  const auto inertia =
      Query("SELECT logs, message, value FROM dive_fits WHERE parameter = 'inertia' AND usable",
            results_);
  ASSERT_EQ(inertia.size(), 1u);
  EXPECT_THAT(inertia[0],
              AllOf(StartsWith("3|Left out: dive/reversed ("), HasSubstr(", dive/other (")));
  // That of the vehicle of small_log.h is 40 kg.
  EXPECT_NEAR(std::stod(inertia[0].substr(inertia[0].rfind('|') + 1)), 40.0, 1.0);
}

}  // namespace
}  // namespace fathom
