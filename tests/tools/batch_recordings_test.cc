// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a batch makes of the files that vehicles' own software wrote.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch_results.h"
#include "run_tool.h"
#include "small_log.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Path = std::filesystem::path;

ToolRun RunBatch(const Path& archive, const Path& results) {
  return RunToolBinary("fathom_batch",
                       {"--archive=" + archive.string(),
                        "--results=" + results.string(),
                        "--families=output_error",
                        "--diagnose=false"});
}

// Two dives: a spreadsheet's export for which there is a map, and a bag of nothing known.
Path WriteArchive(const Path& archive) {
  const Path recordings = Path(FATHOM_DATA_DIR) / "recordings";
  fs::create_directories(archive / "dive_1");
  fs::copy_file(recordings / "pool.csv", archive / "dive_1/pool.csv");
  fs::copy_file(recordings / "pool_map.yaml", archive / "pool_map.yaml");
  WriteTestFile(archive / "dive_2/run.bag", "#ROSBAG V2.0\n");
  WriteTestFile(archive / "archive.yaml", "imports: [{files: '*/pool.csv', map: pool_map.yaml}]\n");
  return archive;
}

TEST(BatchOnRecordings, ImportsThemByTheMapsOfTheArchive) {
  const Path folder = EmptyTestFolder();
  const Path archive = WriteArchive(folder / "archive"), results = folder / "results.sqlite";
  const ToolRun run = RunBatch(archive, results);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::map<std::string, std::string> states = StatesOf(results);
  EXPECT_THAT(states["dive_1/pool.csv"], StartsWith("ok"));
  EXPECT_THAT(states["dive_2/run.bag"], StartsWith("no_map: needs a map"));
  EXPECT_FALSE(fs::exists(archive / "dive_1/log.yaml"));

  // The batch says what a user gets who imports and compares by hand.
  const Path log = folder / "by_hand";
  ASSERT_EQ(RunToolBinary("fathom_import",
                          {"--from=" + (archive / "dive_1/pool.csv").string(),
                           "--map=" + (archive / "pool_map.yaml").string(),
                           "--out=" + log.string()})
                .exit_code,
            0);
  const Path by_hand = folder / "by_hand.sqlite";
  ASSERT_EQ(RunBatch(log, by_hand).exit_code, 0);
  const std::string fits = "SELECT dof, family, parameter, value, std FROM fits ORDER BY rowid";
  EXPECT_EQ(Query(fits, results), Query(fits, by_hand));
  EXPECT_FALSE(Query(fits, results).empty());
}

TEST(BatchOnRecordings, DoesAgainOnlyWhatAMapChanges) {
  const Path folder = EmptyTestFolder();
  const Path archive = WriteArchive(folder / "archive"), results = folder / "results.sqlite";
  ASSERT_EQ(RunBatch(archive, results).exit_code, 0);
  EXPECT_THAT(RunBatch(archive, results).out, HasSubstr("0 logs run now, 2 done before"));

  WriteTestFile(archive / "pool_map.yaml", "velocity: {u: no_such_column}\n");
  EXPECT_THAT(RunBatch(archive, results).out, HasSubstr("1 log run now, 1 done before"));
  EXPECT_THAT(StatesOf(results)["dive_1/pool.csv"],
              StartsWith("refused: " + (archive / "dive_1/pool.csv").string()));
}

TEST(BatchOnRecordings, TellsWhatIsWrongWithTheirMap) {
  const Path folder = EmptyTestFolder();
  const Path archive = WriteArchive(folder / "archive"), results = folder / "results.sqlite";
  fs::remove(archive / "pool_map.yaml");
  ASSERT_EQ(RunBatch(archive, results).exit_code, 0);
  EXPECT_THAT(StatesOf(results)["dive_1/pool.csv"], HasSubstr("pool_map.yaml"));
}

}  // namespace
}  // namespace fathom
