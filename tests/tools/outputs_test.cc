// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What the tools' output flags may name, and what is left where a tool is interrupted.

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>
#include <sys/wait.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using Path = std::filesystem::path;

struct OutputFlag {
  std::string tool;
  std::vector<std::string> flags;  // beside --log
  std::string output;              // the flag under test
};

// Every flag of every tool that names a file to write beside a log.
std::vector<OutputFlag> EveryOutput(const Path& folder) {
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  return {{"fathom_identify", {"--dof=surge"}, "model"},
          {"fathom_compare", {}, "json"},
          {"fathom_compare", {}, "report"},
          {"fathom_diagnose", {"--dof=surge"}, "verdict"},
          {"fathom_diagnose", {"--dof=surge"}, "report"},
          {"fathom_simulate", {"--model=" + model}, "out"},
          {"fathom_refine", {"--dof=surge"}, "json"},
          {"fathom_refine", {"--dof=surge"}, "model"},
          {"fathom_refine", {"--dof=surge"}, "trajectory"},
          {"fathom_refine", {"--dof=surge"}, "report"},
          {"fathom_track", {}, "summary"}};
}

TEST(Outputs, DoNotTakeThePlaceOfAFileOfTheLog) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  for (const OutputFlag& asked : EveryOutput(folder)) {
    auto arguments = asked.flags;
    const std::string file = (log / "command.csv").string();
    arguments.push_back(Flag("log", log));
    arguments.push_back("--" + asked.output + "=" + file);
    EXPECT_EQ(ExpectRefusal(asked.tool, arguments, folder),
              asked.tool + ": --" + asked.output + "=" + file + ": is command.csv of the log " +
                  log.string() + ", expected another file.\n");
  }
}

TEST(Outputs, DoNotTakeThePlaceOfAnInput) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  EXPECT_EQ(
      ExpectRefusal(
          "fathom_simulate", {Flag("log", log), "--model=" + model, "--out=" + model}, folder),
      "fathom_simulate: --out=" + model +
          ": is read by this program, expected another "
          "file.\n");
  const std::string vehicle = WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml()).string();
  EXPECT_THAT(ExpectRefusal("fathom_synthesize",
                            {"--vehicle=" + vehicle,
                             "--experiment=" FATHOM_DATA_DIR "/experiments/film_surge.yaml",
                             Flag("out", folder / "made"),
                             "--truth=" + vehicle},
                            folder),
              HasSubstr("--truth=" + vehicle + ": is read by this program"));
}

TEST(Outputs, AreOneFileEach) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  const std::string file = (folder / "rows").string();
  // The same place by another name.
  const std::string other = (folder / "log" / ".." / "rows").string();
  EXPECT_EQ(
      ExpectRefusal(
          "fathom_compare", {Flag("log", log), "--json=" + file, "--report=" + other}, folder),
      "fathom_compare: --report=" + other +
          ": is the file of --json too, expected another "
          "one.\n");
}

TEST(Outputs, AreTriedBeforeTheWork) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "log");
  EXPECT_THAT(
      ExpectRefusal("fathom_compare",
                    {Flag("log", log), Flag("json", folder / "rows.json"), Flag("report", log)},
                    folder),
      HasSubstr(log.string() + ": is a folder, expected a file to write."));
}

TEST(Outputs, MakeTheFoldersThatAreMissing) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteSmallLog(folder / "archive" / "log");
  const std::string model = WriteTestFile(folder / "model.json", SmallModelJson()).string();
  const auto write = [&](const std::string& tool, std::vector<std::string> flags, const Path& out) {
    EXPECT_FALSE(std::filesystem::exists(out.parent_path()));
    RunsWell(tool, flags);
    EXPECT_TRUE(std::filesystem::exists(out)) << out;
  };
  const std::string log_flag = Flag("log", log);
  const Path identified = folder / "a" / "b" / "model.json";
  write("fathom_identify", {log_flag, "--dof=surge", Flag("model", identified)}, identified);
  const Path score = folder / "c" / "d" / "score.json";
  write("fathom_simulate", {log_flag, "--model=" + model, Flag("json", score)}, score);
  const Path rows = folder / "e" / "f" / "rows.json";
  write("fathom_compare", {log_flag, "--families=least_squares", Flag("json", rows)}, rows);
  const Path results = folder / "g" / "h" / "results.sqlite";
  write("fathom_batch",
        {Flag("archive", folder / "archive"),
         Flag("results", results),
         "--families=least_squares",
         "--nodiagnose"},
        results);
}

TEST(Outputs, MakeNoFolderIfTheInputIsBad) {
  const Path folder = EmptyTestFolder();
  ExpectRefusal("fathom_batch",
                {Flag("archive", folder / "none"),
                 Flag("results", folder / "a" / "results.sqlite"),
                 Flag("csv", folder / "b" / "fits.csv")},
                folder);
}

TEST(Outputs, AreNotLeftHalfWrittenByAnInterrupt) {
  const Path folder = EmptyTestFolder();
  // The 3000 images take minutes: it is in the midst of them as soon as there are some.
  const auto frames = [&] {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (std::filesystem::exists(entry.path() / "frames")) return true;
    }
    return false;
  };
  const auto interrupt_in_the_midst = [&](int tool) {
    for (int i = 0; i < 3000 && !frames(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_TRUE(frames());
    kill(tool, SIGINT);
  };
  const ToolRun run = RunToolBinary("fathom_synthesize",
                                    {"--vehicle=" FATHOM_DATA_DIR "/vehicles/flatfish.yaml",
                                     "--experiment=" FATHOM_DATA_DIR "/experiments/film_surge.yaml",
                                     "--film=" FATHOM_DATA_DIR "/films/wall.yaml",
                                     "--render",
                                     Flag("out", folder / "log")},
                                    interrupt_in_the_midst);
  EXPECT_EQ(run.exit_code, 128 + SIGINT);
  EXPECT_THAT(ListOf(folder), ::testing::IsEmpty());
}

}  // namespace
}  // namespace fathom
