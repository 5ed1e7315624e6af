// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/process/run_child.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "run_tool.h"
#include "saved_files.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::SizeIs;

const std::string kHere = std::string(FATHOM_SOURCE_DIR) + "/tests/tools/";

// stdout of a program that has to work.
std::string Output(const std::string& program, const std::vector<std::string>& arguments) {
  const ChildResult result =
      RunChild({.program = program, .arguments = arguments, .limits = {.wall_time = 60.0}});
  if (result.end != ChildEnd::kExited || result.exit_code != 0) {
    throw std::runtime_error(fmt::format("{} {}: exit code {}: {} {}",
                                         program,
                                         fmt::join(arguments, " "),
                                         result.exit_code,
                                         result.out,
                                         result.err));
  }
  return result.out;
}

void WaitUntil(const std::string& what, const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(40);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) {
      throw std::runtime_error("waited in vain until " + what + ":\n" +
                               Output("squeue", {"-r", "-t", "all"}) + Output("sinfo", {"-N"}));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

// Why there can be no cluster here; empty if there can.
std::string WhyNoSlurm() {
  if (geteuid() != 0) return "Slurm's daemons need root here";
  for (const std::string program : {"slurmctld", "slurmd", "sbatch", "munged"}) {
    bool found = false;
    for (const std::string folder : {"/usr/bin/", "/usr/sbin/", "/usr/local/bin/"}) {
      found = found || fs::exists(folder + program);
    }
    if (!found) return program + " is missing: apt-get install slurm-wlm munge";
  }
  return "";
}

// mini_slurm.sh, which SLURM_CONF then names. It ends with the object, or else with the process.
class MiniSlurm {
 public:
  MiniSlurm() {
    std::string name = "/tmp/fathom_slurm_XXXXXX";
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    folder_ = name;
    try {
      // Below the ports that the system gives to clients.
      const int port = 12000 + 4 * (static_cast<int>(getpid()) % 5000);
      Script({"start", name, std::to_string(port), std::to_string(getpid())});
    } catch (...) {
      Stop();
      throw;
    }
    setenv("SLURM_CONF", (folder_ / "slurm.conf").c_str(), 1);
  }
  ~MiniSlurm() { Stop(); }
  MiniSlurm(const MiniSlurm&) = delete;
  MiniSlurm& operator=(const MiniSlurm&) = delete;

  void Lose(const std::string& node) const { Script({"lose", folder_.string(), node}); }
  fs::path Disk(const std::string& node) const { return folder_ / "disk" / node; }

 private:
  static void Script(const std::vector<std::string>& arguments) {
    Output(kHere + "mini_slurm.sh", arguments);
  }

  void Stop() const {
    try {
      Script({"stop", folder_.string()});
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  fs::path folder_;
};

// Fathom's programs, of which fathom_diagnose on node2 waits until its node is lost. While it does,
// a file in `marks` has its task's and its process's number.
fs::path ToolsThatWait(const fs::path& folder, const fs::path& marks) {
  fs::create_directories(marks);
  for (const std::string name :
       {"batch", "compare", "diagnose", "identify", "refine", "simulate", "track"}) {
    const std::string wait = fmt::format(R"(
if [ "${{SLURMD_NODENAME:-}}" = node2 ] && [ ! -e '{0}/go' ]; then
  echo $$ > '{0}/'"$SLURM_ARRAY_TASK_ID"
  while [ ! -e '{0}/go' ]; do sleep 0.1; done
fi)",
                                         marks.string());
    const fs::path script =
        WriteTestFile(folder / ("fathom_" + name),
                      fmt::format("#!/bin/sh\n{}\nexec '{}/tools/fathom_{}' \"$@\"\n",
                                  name == "diagnose" ? wait : "",
                                  FATHOM_BUILD_DIR,
                                  name));
    fs::permissions(script, fs::perms::owner_all);
  }
  return folder;
}

// The numbers of the tasks that wait on node2.
std::vector<std::string> WaitingTasks(const fs::path& marks) {
  std::vector<std::string> tasks;
  for (const auto& entry : fs::directory_iterator(marks)) {
    if (entry.path().filename() != "go" && !TextOf(entry.path()).empty()) {
      tasks.push_back(entry.path().filename());
    }
  }
  return tasks;
}

// Whether the process whose number stands in a file is there, and no zombie.
bool IsAlive(const fs::path& mark) {
  const std::string number = LinesOf(TextOf(mark)).at(0);
  const std::string status = TextOf(fs::path("/proc") / number / "status");
  return !status.empty() && status.find("State:\tZ") == std::string::npos;
}

// "RUNNING", "PENDING", ...
std::string StateOf(const std::string& job) {
  return Output("squeue", {"-h", "-r", "-t", "all", "-o", "%T", "-j", job});
}

std::vector<std::string> StatesOf(const std::string& array) { return LinesOf(StateOf(array)); }

// Slurm lets tasks that it has queued again wait for so long.
void DoNotWaitTwoMinutes(const std::string& array) {
  for (const std::string& line :
       LinesOf(Output("squeue", {"-h", "-r", "-t", "PD", "-o", "%r %i", "-j", array}))) {
    if (!line.starts_with("BeginTime ")) continue;
    const std::string job = line.substr(line.find(' ') + 1);
    // It may have begun by now.
    RunChild({.program = "scontrol", .arguments = {"update", "jobid=" + job, "starttime=now"}});
  }
}

bool AnyAtWork(const std::vector<std::string>& states) {
  return std::ranges::any_of(states, [](const std::string& state) {
    return state == "PENDING" || state == "CONFIGURING" || state == "RUNNING" ||
           state == "COMPLETING";
  });
}

std::vector<std::string> PublicTables(SQLite::Database* database) {
  std::vector<std::string> names;
  SQLite::Statement select(*database,
                           "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT IN "
                           "('runs', 'files', 'done') ORDER BY name");
  while (select.executeStep()) names.push_back(select.getColumn(0).getString());
  return names;
}

// A table's rows as SQL literals, which give numbers to the last bit; without times and memory.
std::vector<std::string> TableRows(const std::string& table, SQLite::Database* database) {
  std::vector<std::string> columns;
  SQLite::Statement info(*database, "SELECT name FROM pragma_table_info(?)");
  info.bind(1, table);
  while (info.executeStep()) {
    const std::string name = info.getColumn(0).getString();
    if (name != "seconds" && name != "peak_mb") columns.push_back("quote(\"" + name + "\")");
  }
  std::vector<std::string> rows;
  SQLite::Statement select(
      *database, fmt::format("SELECT {} FROM {}", fmt::join(columns, " || ', ' || "), table));
  while (select.executeStep()) rows.push_back(select.getColumn(0).getString());
  std::ranges::sort(rows);
  return rows;
}

int CountOf(const fs::path& database, const std::string& table) {
  SQLite::Database open(database.string(), SQLite::OPEN_READONLY);
  return open.execAndGet("SELECT count(*) FROM " + table).getInt();
}

void ExpectSameTables(const fs::path& ours, const fs::path& theirs) {
  SQLite::Database a(ours.string(), SQLite::OPEN_READONLY);
  SQLite::Database b(theirs.string(), SQLite::OPEN_READONLY);
  const std::vector<std::string> tables = PublicTables(&a);
  EXPECT_THAT(tables, IsSupersetOf({"logs", "fits", "verdicts", "causes", "changes"}));
  EXPECT_EQ(tables, PublicTables(&b));
  for (const std::string& table : tables) {
    EXPECT_EQ(TableRows(table, &a), TableRows(table, &b)) << table;
  }
}

// Names of what is in a folder.
std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

class BatchOnSlurm : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = WhyNoSlurm(); !why.empty()) GTEST_SKIP() << why;
    setenv("PATH", fmt::format("{}/tools:{}", FATHOM_BUILD_DIR, std::getenv("PATH")).c_str(), 1);
    Output(std::string(FATHOM_SOURCE_DIR) + "/data/examples/example_archive.sh",
           {archive_.string(), "6", "2"});
    tools_ = ToolsThatWait(folder_ / "tools", marks_);
  }

  // Writes the job script and submits all parts, then the merge; their numbers.
  std::pair<std::string, std::string> Submit() const {
    const fs::path job = folder_ / "shared" / "the job.sbatch";
    fs::create_directories(folder_ / "shared");
    const ToolRun plan = RunToolBinary("fathom_batch",
                                       {Flag("archive", archive_),
                                        Flag("results", results_),
                                        Flag("tools", tools_),
                                        "--plan=4",
                                        Flag("slurm", job)});
    if (plan.exit_code != 0) throw std::runtime_error(plan.err);
    const std::string logs = Flag("output", folder_ / "shared/%A_%a.out");
    std::string array = Output("sbatch", {"--parsable", "--array=0-3", logs, job.string()});
    array.pop_back();
    std::string merge = Output(
        "sbatch", {"--parsable", "--dependency=afterok:" + array, logs, job.string(), "merge"});
    merge.pop_back();
    return {array, merge};
  }

  // What the tasks wrote.
  std::string Outputs() const {
    std::string text;
    for (const auto& entry : fs::directory_iterator(folder_ / "shared")) {
      if (entry.path().extension() == ".out") {
        text += entry.path().filename().string() + ":\n" + TextOf(entry.path());
      }
    }
    return text;
  }

  void RunOnOneMachine(const fs::path& results) const {
    RunsWell("fathom_batch", {Flag("archive", archive_), Flag("results", results), "--jobs=2"});
  }

  const fs::path folder_ = EmptyTestFolder();
  const fs::path archive_ = folder_ / "a vehicle's dives, 2026";
  const fs::path results_ = folder_ / "shared" / "the $results, \"all\".sqlite";
  const fs::path marks_ = folder_ / "marks";
  fs::path tools_;
};

TEST_F(BatchOnSlurm, LosesANodeAndGivesWhatOneMachineGives) {
  const MiniSlurm slurm;
  const auto [array, merge] = Submit();

  // node2 dies with its disk while its tasks work.
  WaitUntil("a task on node2 works",
            [&] { return !WaitingTasks(marks_).empty() || !AnyAtWork(StatesOf(array)); });
  const std::vector<std::string> victims = WaitingTasks(marks_);
  ASSERT_THAT(victims, Not(IsEmpty())) << Outputs();
  for (const std::string& task : victims) {
    ASSERT_TRUE(IsAlive(marks_ / task)) << "task " << task << " had ended by itself";
    ASSERT_EQ(StateOf(array + "_" + task), "RUNNING\n");
    ASSERT_FALSE(fs::exists(results_.string() + ".part" + task));
  }
  EXPECT_THAT(NamesIn(slurm.Disk("node2")), Not(IsEmpty()));
  slurm.Lose("node2");
  for (const std::string& task : victims) ASSERT_FALSE(IsAlive(marks_ / task)) << task;
  fs::remove_all(slurm.Disk("node2"));
  fs::create_directory(slurm.Disk("node2"));
  WriteTestFile(marks_ / "go", "");
  // Slurm would see it after SlurmdTimeout. The node does not come back: what Slurm still has to
  // tell it of the lost tasks would hit them as they run again, but for the two minutes.
  Output("scontrol", {"update", "nodename=node2", "state=down", "reason=lost"});

  WaitUntil("the merge has ended", [&, array = array, merge = merge] {
    DoNotWaitTwoMinutes(array);
    const std::vector<std::string> states = StatesOf(array);
    return std::ranges::count(states, "FAILED") > 0 || !AnyAtWork(StatesOf(merge));
  });
  EXPECT_THAT(StatesOf(array), testing::Each("COMPLETED")) << Outputs();
  EXPECT_THAT(StatesOf(array), SizeIs(4));
  ASSERT_EQ(StateOf(merge), "COMPLETED\n") << Outputs();
  for (const std::string& task : victims) {
    EXPECT_THAT(Output("scontrol", {"show", "job", array + "_" + task}), HasSubstr("Restarts=1"));
  }

  const fs::path alone = folder_ / "alone.sqlite";
  RunOnOneMachine(alone);
  ExpectSameTables(alone, results_);
  EXPECT_EQ(CountOf(results_, "logs"), 12);
  EXPECT_EQ(CountOf(results_, "verdicts"), 12);
  EXPECT_GT(CountOf(results_, "dive_fits"), 0);
  EXPECT_GT(CountOf(results_, "predictions"), 0);
  // The merge ran only what is of whole dives.
  EXPECT_THAT(Outputs(), HasSubstr("12 logs in 6 dives: 12 ok\n0 logs run"));
  EXPECT_EQ(CountOf(results_, "runs"), CountOf(alone, "runs"));
  EXPECT_THAT(Outputs(), Not(HasSubstr("No statement on change")));

  // Nothing is left behind.
  EXPECT_THAT(NamesIn(slurm.Disk("node1")), IsEmpty());
  EXPECT_THAT(NamesIn(slurm.Disk("node2")), IsEmpty());
  EXPECT_THAT(NamesIn(results_.parent_path()), Not(Contains(HasSubstr("copy"))));
}

}  // namespace
}  // namespace fathom
