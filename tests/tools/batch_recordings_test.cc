// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a batch makes of the files that vehicles' own software wrote.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "batch_results.h"
#include "real_data.h"
#include "run_tool.h"
#include "small_log.h"
#include <fmt/ranges.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Path = std::filesystem::path;

ToolRun RunBatchOfRecordings(const Path& archive, const Path& results) {
  return RunToolBinary("fathom_batch",
                       {"--archive=" + archive.string(),
                        "--results=" + results.string(),
                        "--families=output_error",
                        "--diagnose=false"});
}

// Two dives: a spreadsheet's export for which there is a map, and a bag of nothing known.
Path WriteRecordings(const Path& archive) {
  const Path recordings = Path(FATHOM_DATA_DIR) / "recordings";
  fs::create_directories(archive / "dive_1");
  fs::copy_file(recordings / "pool.csv", archive / "dive_1/pool.csv");
  fs::copy_file(recordings / "pool_map.yaml", archive / "pool_map.yaml");
  WriteTestFile(archive / "dive_2/run.bag", "#ROSBAG V2.0\n");
  WriteTestFile(archive / "archive.yaml", "imports: [{files: '*/pool.csv', map: pool_map.yaml}]\n");
  return archive;
}

// Without so many lines at the end.
void CopyWithout(std::size_t num_lines, const Path& from, const Path& to) {
  std::ifstream file(from);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line + "\n");
  lines.resize(lines.size() - num_lines);
  WriteTestFile(to, fmt::format("{}", fmt::join(lines, "")));
}

TEST(BatchOnRecordings, ImportsThemByTheMapsOfTheArchive) {
  const Path folder = EmptyTestFolder();
  const Path archive = WriteRecordings(folder / "archive"), results = folder / "results.sqlite";
  const ToolRun run = RunsWell(RunBatchOfRecordings(archive, results));
  std::map<std::string, std::string> states = StatesOf(results);
  EXPECT_THAT(states["dive_1/pool.csv"], StartsWith("ok"));
  EXPECT_THAT(states["dive_2/run.bag"], StartsWith("no_map: needs a map"));
  EXPECT_FALSE(fs::exists(archive / "dive_1/log.yaml"));

  // The batch says what a user gets who imports and compares by hand.
  const Path log = folder / "by_hand";
  RunsWell("fathom_import",
           {"--from=" + (archive / "dive_1/pool.csv").string(),
            "--map=" + (archive / "pool_map.yaml").string(),
            "--out=" + log.string()});
  const Path by_hand = folder / "by_hand.sqlite";
  RunsWell(RunBatchOfRecordings(log, by_hand));
  const std::string fits = "SELECT dof, family, parameter, value, std FROM fits ORDER BY rowid";
  EXPECT_EQ(Query(fits, results), Query(fits, by_hand));
  EXPECT_FALSE(Query(fits, results).empty());
}

TEST(BatchOnRecordings, DoesAgainOnlyWhatAMapChanges) {
  const Path folder = EmptyTestFolder();
  const Path archive = WriteRecordings(folder / "archive"), results = folder / "results.sqlite";
  RunsWell(RunBatchOfRecordings(archive, results));
  EXPECT_THAT(RunBatchOfRecordings(archive, results).out,
              HasSubstr("0 logs run now, 2 done before"));

  WriteTestFile(archive / "pool_map.yaml", "velocity: {u: no_such_column}\n");
  EXPECT_THAT(RunBatchOfRecordings(archive, results).out,
              HasSubstr("1 log run now, 1 done before"));
  EXPECT_THAT(StatesOf(results)["dive_1/pool.csv"],
              StartsWith("refused: " + (archive / "dive_1/pool.csv").string()));
}

// A new recording is fitted together with what was made of those before; that is made again where
// it is gone.
TEST(BatchOnRecordings, TakesTheLogsThatItMadeBefore) {
  const Path folder = EmptyTestFolder();
  const Path archive = WriteRecordings(folder / "archive"), results = folder / "results.sqlite";
  WriteTestFile(archive / "archive.yaml",
                "imports: [{files: '*/pool*.csv', map: pool_map.yaml}]\n");
  RunsWell(RunBatchOfRecordings(archive, results));
  CopyWithout(1, archive / "dive_1/pool.csv", archive / "dive_1/pool_2.csv");
  EXPECT_THAT(RunBatchOfRecordings(archive, results).out,
              HasSubstr("1 log run now, 2 done before"));
  fs::remove_all(results.string() + ".logs");
  CopyWithout(2, archive / "dive_1/pool.csv", archive / "dive_1/pool_3.csv");
  EXPECT_THAT(RunBatchOfRecordings(archive, results).out,
              HasSubstr("3 logs run now, 1 done before"));
  const auto rows = PublicRows(results);
  fs::remove(results);
  RunBatchOfRecordings(archive, results);
  EXPECT_EQ(rows, PublicRows(results));
}

TEST(BatchOnRecordings, TellsWhatIsWrongWithTheirMap) {
  const Path folder = EmptyTestFolder();
  const Path archive = WriteRecordings(folder / "archive"), results = folder / "results.sqlite";
  fs::remove(archive / "pool_map.yaml");
  RunsWell(RunBatchOfRecordings(archive, results));
  EXPECT_THAT(StatesOf(results)["dive_1/pool.csv"], HasSubstr("pool_map.yaml"));
}

using BatchOnRealRecordings = OnRealData;

// All recordings of others there are, some of them with a map: each ends in its right state.
TEST_F(BatchOnRealRecordings, EndsEachInItsRightState) {
  const Path folder = EmptyTestFolder();
  const Path archive = folder / "archive", results = folder / "results.sqlite";
  fs::create_directories(archive);
  fs::create_directory_symlink(folder_ / "formats", archive / "formats");
  fs::create_directory_symlink(folder_ / "sonia", archive / "sonia");
  WriteTestFile(archive / "sonia.yaml", R"(
dof: sway
command: {channel: Thrust, rate: 180, frame: FRD, tau_sway: {field: 2, scale: 9.80665, unit: N}}
velocity: {channel: LINEAR_SPEED, rate: 8, v: {field: 2, unit: m/s}}
)");
  WriteTestFile(archive / "rock.yaml", R"(
dof: surge
command:
  channel: "/forces&torques.forces"
  frame: FLU
  time: time
  tau_surge: {field: "elements[0].effort", unit: N}
velocity: {channel: /adap_samples.velocity, frame: FLU, time: time, u: "velocity.data[0]"}
)");
  WriteTestFile(archive / "archive.yaml",
                "imports:\n"
                "  - {files: 'sonia/y_*.mat', map: sonia.yaml}\n"
                "  - {files: formats/pocolog, map: rock.yaml}\n");
  RunsWell(RunBatchOfRecordings(archive, results));
  int num_without_map = 0;
  for (const auto& [log, state] : StatesOf(results)) {
    SCOPED_TRACE(log);
    if (log == "formats/pocolog") {
      EXPECT_THAT(state, StartsWith("ok"));
    } else if (log.starts_with("sonia/y_") && log.ends_with(".mat")) {
      // Of 22 s each, one determines no model of its own.
      EXPECT_THAT(state, AnyOf(StartsWith("ok"), StartsWith("no_model")));
    } else if (log == "sonia/essai_1_x10_2017-11-18-22-16-18.bag") {
      EXPECT_THAT(state, StartsWith("duplicate"));
    } else {
      EXPECT_THAT(state, StartsWith("no_map"));
      ++num_without_map;
    }
  }
  // 22 + 3 bags, 2 MCAP, 2 .db3, 4 .BIN, 2 .ulg, 1 .tlog, 4 .mat, 2 .alog; 2 bags and 6 .mat of
  // sonia.
  EXPECT_EQ(num_without_map, 50);
}

}  // namespace
}  // namespace fathom
